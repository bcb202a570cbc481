#include "creation.h"

#include "cases/core/structs.h"

namespace agaa::conformance {

std::string apiName(const Device& device, const std::string& function) {
    return (device.backend() == Backend::Vulkan ? "agaaVk" : "agaaGl") + function;
}

void addApiCase(Suite& suite, const std::string& function, const std::string& promise,
                const std::function<void(Test&)>& run) {
    suite.add("agaaVk" + function + "/" + promise, {Backend::Vulkan}, run);
    suite.add("agaaGl" + function + "/" + promise, {Backend::OpenGl}, run);
}

std::string objectsText(const std::map<std::string, int64_t>& objects) {
    std::string text;
    for (const auto& [kind, number] : objects)
        text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + kind;
    return text.empty() ? "nothing" : text;
}

void expectNoMessages(Test& test, const std::string& after) {
    for (const std::string& message : test.device().takeMessages())
        test.check(false, after + " causes a message: " + message);
}

void expectContextRefused(Test& test, const ContextRow& row) {
    test.device().takeMessages(); // removes messages of earlier calls
    const std::string function = apiName(test.device(), "CreateContext"), what = function + " with " + row.what;
    ContextDescription description = test.device().description();
    LogRecorder log;
    description.desc.log = log.get();
    row.change(description);
    AgaaContext context = untouchedHandle<AgaaContext>();
    const AgaaResult result = test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context);
    if (row.isSilent)
        expectRefused(test, result, row.expected, what);
    else
        expectRefused(test, result, row.expected, log, function, what, row.words);
    if (result == AGAA_OK)
        test.sdk.agaaDestroyContext(context);
    else
        test.check(context == untouchedHandle<AgaaContext>(), what + " fails and changes outContext.");
    expectNoMessages(test, what);
}

void testContextRows(Test& test, const std::vector<ContextRow>& rows) {
    test.require(!rows.empty(), "the test has no rows.");
    for (const ContextRow& row : rows)
        expectContextRefused(test, row);
}

void expectContextAccepted(Test& test, const std::string& what, const ChangeContext& change) {
    ContextDescription description = test.device().description();
    LogRecorder log;
    description.desc.log = log.get();
    change(description);
    AgaaContext context = nullptr;
    const AgaaResult result = test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context);
    const std::vector<LogLine> errors = log.errors();
    if (!test.result(result, AGAA_OK,
                     apiName(test.device(), "CreateContext") + " with " + what +
                         (errors.empty() ? "" : " (\"" + errors[0].text + "\")")))
        return;
    test.check(errors.empty(), "creating a context with " + what + " succeeds and logs an error.");
    test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext after " + what);
    expectNoMessages(test, "a context with " + what);
}

std::vector<ContextRow> rowsOf(const std::vector<ContextRow>& rows, AgaaResult expected) {
    std::vector<ContextRow> some;
    for (const ContextRow& row : rows)
        if (row.expected == expected)
            some.push_back(row);
    return some;
}

namespace {

void* AGAA_CALL allocate(void*, size_t, size_t) { return nullptr; }
void AGAA_CALL release(void*, void*) {}

} // namespace

std::vector<ContextRow> wrongContexts() {
    static const AgaaStructHeader unknown = {farStructType, sizeof(AgaaStructHeader), nullptr};
    static const AgaaLog wrongLog = {0, sizeof(AgaaLog), nullptr, nullptr, nullptr};
    std::vector<ContextRow> rows;
    for (const uint32_t frames : {0u, 9u, 0x80000000u, 0xFFFFFFFFu})
        rows.push_back({"AgaaContextDesc::framesInFlight = " + std::to_string(frames), AGAA_ERROR_OUT_OF_RANGE,
                        "framesInFlight", [=](ContextDescription& d) { d.desc.framesInFlight = frames; }});
    for (const uint32_t value : {1u, 0x80000000u})
        rows.push_back({"AgaaContextDesc::reserved = " + std::to_string(value), AGAA_ERROR_OUT_OF_RANGE, "reserved",
                        [=](ContextDescription& d) { d.desc.reserved = value; }});
    rows.push_back({"AgaaContextDesc::allocate without free", AGAA_ERROR_INVALID_ARGUMENT, "allocate",
                    [](ContextDescription& d) { d.desc.allocate = allocate; }});
    rows.push_back({"AgaaContextDesc::free without allocate", AGAA_ERROR_INVALID_ARGUMENT, "free",
                    [](ContextDescription& d) { d.desc.free = release; }});
    rows.push_back({"an unknown struct in the chain", AGAA_ERROR_UNKNOWN_STRUCT, std::to_string(farStructType),
                    [](ContextDescription& d) { d.desc.pNext = &unknown; }});
    rows.push_back(
        {"AgaaContextDesc::sType = 0", AGAA_ERROR_STRUCT, "", [](ContextDescription& d) { d.desc.sType = 0; }, true});
    rows.push_back(
        {"AgaaLog::sType = 0", AGAA_ERROR_STRUCT, "", [](ContextDescription& d) { d.desc.log = &wrongLog; }, true});
    // The library skips the struct, and finds no device.
    const auto hide = [](ContextDescription& d) {
        d.vk.sType = d.gl.sType = farStructType | AGAA_STRUCTURE_TYPE_OPTIONAL_BIT;
    };
    rows.push_back({"no device in the chain", AGAA_ERROR_INVALID_ARGUMENT, "DeviceDesc", hide});
    return rows;
}

} // namespace agaa::conformance
