"""Writes the C# binding Agaa.cs from the description of the C ABI, for tools/generate_bindings.py.

All structs are blittable, so that arrays and pNext chains of them are those of C. The code is C# 7.
"""

BINDING = "bindings/csharp/Agaa.cs"
LAYOUT = "tests/bindings/Layout.cs"
SCALARS = {"void": "void", "char": "byte", "int": "int", "float": "float", "double": "double", "uint32_t": "uint",
           "int32_t": "int", "uint64_t": "ulong", "int64_t": "long", "size_t": "UIntPtr", "AgaaResult": "AgaaResultCode"}
KEYWORDS = set("abstract as base bool break byte case catch char checked class const continue decimal default delegate do "
               "double else enum event explicit extern false finally fixed float for foreach goto if implicit in int interface "
               "internal is lock long namespace new null object operator out override params private protected public "
               "readonly ref return sbyte sealed short sizeof stackalloc static string struct switch this throw true try "
               "typeof uint ulong unchecked unsafe ushort using virtual void volatile while".split())
COLUMNS = 120


def identifier(name):
    return f"@{name}" if name in KEYWORDS else name


def type_name(name, callbacks):
    """Returns the C# type of a C type. C# has no const."""
    name = name.replace("const ", "").replace(" const", "")
    stars = name.count("*") + name.count("[]")
    name = name.replace("*", "").replace("[]", "")
    return ("IntPtr" if name in callbacks else SCALARS.get(name, name)) + "*" * stars


def declaration(start, signature, callbacks, indent):
    """Returns the lines of a function or delegate."""
    parameters = [f"{type_name(each['type'], callbacks)} {identifier(each['name'])}" for each in signature["parameters"]]
    start = f"{indent}{start.format(type_name(signature['returns'], callbacks))}("
    line = f"{start}{', '.join(parameters)});"
    if len(line) <= COLUMNS:
        return [line]
    return [start] + [f"{indent}    {parameter}{',' if index + 1 < len(parameters) else ');'}"
                      for index, parameter in enumerate(parameters)]


def is_inline(member, structs):
    return "lengths" in member and member["type"] in structs


def member_lines(member, structs, callbacks):
    name, kind = identifier(member["name"]), type_name(member["type"], callbacks)
    if member["type"] in callbacks:
        yield f"        /// <summary>{member['type']}</summary>"
    if "lengths" not in member:
        yield f"        public {kind} {name};"
    elif is_inline(member, structs):
        yield f"        public {kind}_{member['lengths'][0]} {name};"
    elif kind in SCALARS.values():
        if len(member["lengths"]) > 1:
            yield f"        /// <summary>{''.join(f'[{length}]' for length in member['lengths'])}</summary>"
        count = 1
        for length in member["lengths"]:
            count *= length
        yield f"        public fixed {kind} {name}[{count}];"
    else:
        raise SystemExit(f"C# has no array of {member['type']} for {member['name']}.")


def struct_lines(name, struct, init, description):
    yield from ("    [StructLayout(LayoutKind.Sequential)]", f"    public unsafe struct {name}", "    {")
    for member in struct["members"]:
        yield from member_lines(member, description["structs"], description["callbacks"])
    if init is not None:
        size = f", (UIntPtr)sizeof({name})" if len(init["parameters"]) > 1 else ""
        yield from ("", "        /// <summary>Returns the struct with its defaults.</summary>",
                    f"        public static {name} Init()", "        {", f"            {name} value = default({name});",
                    f"            Agaa.{init['name']}(&value{size});", "            return value;", "        }")
    yield from ("    }", "")


def inline_array(name, length):
    """C# has fixed buffers of numbers only: an array of structs is a struct of its elements."""
    yield from (f"    /// <summary>{name}[{length}] inside a struct.</summary>", "    [StructLayout(LayoutKind.Sequential)]",
                f"    public unsafe struct {name}_{length}", "    {", f"        public const int Length = {length};")
    yield from (f"        public {name} element{index};" for index in range(length))
    yield from ("", f"        public ref {name} this[int index]", "        {", "            get", "            {",
                "                if ((uint)index >= Length)", "                    throw new IndexOutOfRangeException();",
                f"                fixed ({name}* first = &element0)", "                    return ref first[index];",
                "            }", "        }", "    }", "")


def constants(description):
    for name, value in description["constants"].items():
        yield f"        public const {SCALARS[description['constantTypes'][name]]} {name} = {value};"


def enums(description):
    for enum, values in description["enums"].items():
        yield from (f"    public enum {enum} : {'int' if min(values.values()) < 0 else 'uint'}", "    {")
        # Values MAX_ENUM only give enumerations of C their size.
        yield from (f"        {name} = {value}," for name, value in values.items() if not name.endswith("_MAX_ENUM"))
        yield from ("    }", "")


HEADER = """// <auto-generated/>
// {generated}

using System;
using System.Runtime.InteropServices;
using System.Text;

// The functions, structs and constants of the AGAA SDK with their names in C. The headers and the guides in
// docs/integration describe them, and how long pointers must be valid: pin managed objects, and keep delegates that the
// library calls. Compile with -unsafe.
namespace AgaaSdk
{{"""

CLASS = """    public static unsafe class Agaa
    {{
#if AGAA_WINDOWS
        public const string Library = "agaa";
#else
        /// <summary>The soname: the file libagaa.so belongs to the package of the headers.</summary>
        public const string Library = "libagaa.so.{major}.{minor}";
#endif
"""

TEXT = """
        /// <summary>The version that agaaGetVersion returns if the library is that of this binding.</summary>
        public const uint AGAA_HEADER_VERSION =
            AGAA_VERSION_MAJOR << 22 | AGAA_VERSION_MINOR << 12 | AGAA_VERSION_PATCH;

        /// <summary>Returns the bytes of a text for the library, with a 0 at the end.</summary>
        public static byte[] Utf8(string text)
        {
            return Encoding.UTF8.GetBytes(text + '\\0');
        }

        /// <summary>Returns a text of the library; null if the pointer is null.</summary>
        public static string Text(byte* text)
        {
            if (text == null)
                return null;
            int length = 0;
            while (text[length] != 0)
                ++length;
            byte[] bytes = new byte[length];
            Marshal.Copy((IntPtr)text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }
"""


def source(description, generated):
    callbacks, structs = description["callbacks"], description["structs"]
    functions = {function["name"]: function for function in description["functions"]}
    major, minor, _ = description["version"].split(".")
    yield HEADER.format(generated=generated)
    yield from enums(description)
    for name in description["handles"]:
        yield from ("    [StructLayout(LayoutKind.Sequential)]", f"    public struct {name}", "    {",
                    "        public IntPtr handle;", "    }", "")
    for name, callback in callbacks.items():
        yield "    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]"
        yield from declaration(f"public unsafe delegate {{}} {name}", callback, callbacks, "    ")
        yield ""
    inline = sorted({(member["type"], member["lengths"][0]) for struct in structs.values() for member in struct["members"]
                     if is_inline(member, structs)})
    for name, length in inline:
        yield from inline_array(name, length)
    for name, struct in structs.items():
        yield from struct_lines(name, struct, functions.get("agaaInit" + name.removeprefix("Agaa")), description)
    yield CLASS.format(major=major, minor=minor)
    yield from constants(description)
    yield TEXT.rstrip("\n")
    for name, function in functions.items():
        yield from ("", "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]")
        yield from declaration(f"public static extern {{}} {name}", function, callbacks, "        ")
    yield from ("    }", "}")


def layout(description, generated):
    yield from (f"// {generated}", "// The sizes and offsets of the structs, on 64-bit hosts.", "using AgaaSdk;", "",
                "static unsafe class Layout", "{", "    public static void Check()", "    {")
    for name, struct in description["structs"].items():
        yield f"        Consumer.CheckSize<{name}>(sizeof({name}), {struct['size']});"
        yield from (f"        Consumer.CheckOffset<{name}>(\"{member['name']}\", {member['offset']});" for member in struct["members"])
    yield from ("    }", "}")


def files(description, generated):
    """Returns the lines of each file by its path from the root."""
    return {BINDING: source(description, generated), LAYOUT: layout(description, generated)}
