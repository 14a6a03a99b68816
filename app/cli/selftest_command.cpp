// skyseal-cli selftest: known-answer tests on this machine, one line each.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/engine/headless/self_test.h"

namespace skyseal::app {

int runSelfTest(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli selftest");
    Options options(name,
                    QStringLiteral("Checks ciphers, handshake, MAVLink and a session in this process against known answers."));
    options.addFlag("json", "One JSON object per line on stdout.");
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    if (const auto status = options.finish())
        return *status;

    bool allPassed = true;
    for (const engine::SelfTest &test : engine::selfTests()) {
        const std::optional<std::string> problem = test.run();
        allPassed = allPassed && !problem;
        if (options.has("json")) {
            JsonWriter json;
            json.beginObject().field("event", "selftest").field("name", test.name).field("passed", !problem);
            if (problem)
                json.field("problem", *problem);
            json.endObject();
            printLine(json.text());
        } else {
            printLine((problem ? "FAIL  " : "pass  ") + test.name + (problem ? ": " + *problem : ""));
        }
    }
    return allPassed ? kDone : kNotReached;
}

} // namespace skyseal::app
