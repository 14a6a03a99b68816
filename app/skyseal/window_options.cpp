#include "app/skyseal/window_options.h"

#include "app/common/options.h"

namespace skyseal::app {

std::variant<WindowOptions, int> readOptions(const QStringList &arguments)
{
    constexpr double kDay = 86400;
    Options options(QStringLiteral("skyseal"), QStringLiteral("Ground control station with a sealed MAVLink link."));
    options.addLink(
        "link", "Link to open; may be given several times. Default: the link of the settings, initially udpin:0.0.0.0:14550.");
    options.addFlag("demo", "Fly a simulated vehicle behind its own agent, with new keys.");
    options.addValue("identity", "FILE", "Private key of this station, instead of the user's own.");
    options.addValue("peers", "FILE", "File of known peers, for --identity.");
    PassphraseInput::declare(options);
    options.addValue("screenshot", "FILE", "Save a picture of the window and exit.");
    options.addValue("after", "S", "Take the picture after this many seconds.", "3");
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    WindowOptions out;
    out.links = options.urls("link");
    out.demo = options.has("demo");
    out.screenshot = QString::fromStdString(options.text("screenshot"));
    out.screenshotAfter = options.number("after", 0, kDay);
    out.identityFile = options.text("identity");
    out.peersFile = options.text("peers");
    out.passphrase = PassphraseInput::read(options);
    if (out.identityFile.empty() != out.peersFile.empty())
        options.fail("--identity and --peers require each other");
    if (out.demo && !out.identityFile.empty())
        options.fail("--demo creates its own keys; omit --identity and --peers");
    if (const auto status = options.finish())
        return *status;
    return out;
}

} // namespace skyseal::app
