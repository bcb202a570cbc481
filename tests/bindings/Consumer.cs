// Asks the library about a view without a device, as tests/abi/consumer.c does, and makes an error.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AgaaSdk;

static unsafe class Consumer
{
    static readonly List<string> messages = new List<string>();
    static AgaaResultCode code;

    static void CheckEqual<T>(string name, T found, T expected)
    {
        if (!found.Equals(expected))
            throw new Exception(name + " is " + found + ", not " + expected + ".");
    }

    public static void CheckSize<T>(int size, int expected)
    {
        CheckEqual("The size of " + typeof(T), size, expected);
        CheckEqual("The marshalled size of " + typeof(T), Marshal.SizeOf(typeof(T)), expected);
    }

    public static void CheckOffset<T>(string member, int expected)
    {
        CheckEqual("The offset of " + typeof(T) + "." + member, (int)Marshal.OffsetOf(typeof(T), member), expected);
    }

    static void CheckNames()
    {
        uint count;
        CheckEqual("agaaGetNames", Agaa.agaaGetNames((uint)AgaaNameKind.AGAA_NAMES_TECHNIQUES, &count, null),
                   AgaaResultCode.AGAA_OK);
        byte*[] names = new byte*[count];
        fixed (byte** first = names)
            CheckEqual("agaaGetNames", Agaa.agaaGetNames((uint)AgaaNameKind.AGAA_NAMES_TECHNIQUES, &count, first),
                       AgaaResultCode.AGAA_OK);
        foreach (byte* name in names)
        {
            if (Agaa.Text(name) == "simple_complex")
                return;
        }
        throw new Exception("The techniques lack simple_complex.");
    }

    static long PassesOfLitAggregates(AgaaViewDesc* view, AgaaLog* log)
    {
        uint count;
        CheckEqual("agaaQueryPrices", Agaa.agaaQueryPrices(view, null, log, &count, null), AgaaResultCode.AGAA_OK);
        AgaaPrice[] prices = new AgaaPrice[count];
        for (uint i = 0; i < count; ++i)
            prices[i] = AgaaPrice.Init();
        fixed (AgaaPrice* first = prices)
            CheckEqual("agaaQueryPrices", Agaa.agaaQueryPrices(view, null, log, &count, first), AgaaResultCode.AGAA_OK);
        foreach (AgaaPrice price in prices)
        {
            if (Agaa.Text(price.name) == "lit-aggregates")
                return price.geometryPasses;
        }
        throw new Exception("The prices lack lit-aggregates.");
    }

    // Arrays of structs inside structs are structs with an indexer.
    static void CheckInlineArrays(AgaaLayout layout)
    {
        layout.attributes[1].sampleBits = 7;
        AgaaLayout copy = layout;
        CheckEqual("An element of a copy", copy.attributes[1].sampleBits, 7u);
        try
        {
            copy.attributes[(int)Agaa.AGAA_MAX_LAYOUT_ATTRIBUTES].sampleBits = 7;
        }
        catch (IndexOutOfRangeException)
        {
            return;
        }
        throw new Exception("AgaaLayout.attributes has an element behind its end.");
    }

    static void Run()
    {
        CheckEqual("The version", Agaa.agaaGetVersion(), Agaa.AGAA_HEADER_VERSION);
        CheckNames();

        // The variable keeps the delegate while the library may call it.
        AgaaLogCallback keep = (user, severity, result, message) =>
        {
            CheckEqual("The severity", severity, (uint)AgaaSeverity.AGAA_SEVERITY_ERROR);
            code = result;
            messages.Add(Agaa.Text(message));
        };
        AgaaLog log = AgaaLog.Init();
        log.callback = Marshal.GetFunctionPointerForDelegate(keep);

        AgaaLayout layout = AgaaLayout.Init();
        fixed (byte* name = Agaa.Utf8("paper16"))
            CheckEqual("agaaGetBuiltinLayout", Agaa.agaaGetBuiltinLayout(name, &layout), AgaaResultCode.AGAA_OK);
        CheckInlineArrays(layout);
        AgaaConfig config = AgaaConfig.Init();
        CheckEqual("The technique", Agaa.Text(config.technique), "agaa");
        CheckEqual("The number of samples", config.samples, 8u);
        config.layout = &layout;
        config.visibilityTier = (uint)AgaaTier.AGAA_TIER_NATIVE;
        config.generationTier = (uint)AgaaTier.AGAA_TIER_NV_MIXED_SAMPLES;
        AgaaSceneFacts facts = AgaaSceneFacts.Init();
        facts.maxLights = 1; // more lights have masks for each tile of pixels
        AgaaViewDesc view = AgaaViewDesc.Init();
        view.width = 640;
        view.height = 360;
        view.config = &config;
        view.facts = &facts;

        AgaaMemoryReport report = AgaaMemoryReport.Init();
        AgaaResultCode queried = Agaa.agaaQueryMemory(&view, null, &log, &report, null, null);
        Console.WriteLine(queried + ": " + report.bytesPerPixel + " bytes per pixel");
        CheckEqual("agaaQueryMemory", queried, AgaaResultCode.AGAA_OK);
        CheckEqual("AgaaMemoryReport.bytesPerPixel", report.bytesPerPixel, 81.0);

        AgaaConfig standard = AgaaConfig.Init();
        view.config = &standard;
        // One geometry pass in place of two.
        CheckEqual("AgaaPrice.geometryPasses", PassesOfLitAggregates(&view, &log), -1L);
        CheckEqual("The number of messages", messages.Count, 0);

        standard.flags = 1UL << 40;
        queried = Agaa.agaaQueryMemory(&view, null, &log, &report, null, null);
        GC.KeepAlive(keep);
        CheckEqual("agaaQueryMemory", queried, AgaaResultCode.AGAA_ERROR_OUT_OF_RANGE);
        CheckEqual("The number of messages", messages.Count, 1);
        Console.WriteLine(messages[0]);
        CheckEqual("The code of the message", code, AgaaResultCode.AGAA_ERROR_OUT_OF_RANGE);
        if (!messages[0].StartsWith("agaaQueryMemory") || !messages[0].Contains("0x10000000000"))
            throw new Exception("The message does not name the function and the flag.");
    }

    static void Main()
    {
        Layout.Check();
        Run();
    }
}
