#include "app/skyseal/window_options.h"

#include "app/common/options.h"

namespace skyseal::app {

std::variant<WindowOptions, int> readOptions(const QStringList &arguments)
{
    constexpr double kDay = 86400;
    Options options(QStringLiteral("skyseal"), QStringLiteral("Ground control station with a sealed MAVLink link."));
    options.addLink(
        "link",
        "Open this link; may be given several times. Without it: the link of the settings, udpin:0.0.0.0:14550 at first.");
    options.addFlag("demo", "Fly a simulated vehicle behind an agent of its own, with fresh keys.");
    options.addValue("identity", "FILE", "Private key of this station, instead of the user's own.");
    options.addValue("peers", "FILE", "The known peers that go with it.");
    PassphraseInput::declare(options);
    options.addValue("screenshot", "FILE", "Save a picture of the window and leave.");
    options.addValue("after", "S", "Take the picture after so many seconds.", "3");
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
        options.fail("--identity and --peers go together");
    if (out.demo && !out.identityFile.empty())
        options.fail("--demo makes its own keys: leave --identity and --peers away");
    if (const auto status = options.finish())
        return *status;
    return out;
}

} // namespace skyseal::app
