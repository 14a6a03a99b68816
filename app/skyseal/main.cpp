// skyseal: the desktop ground control station.
#include "app/skyseal/application.h"

#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/process.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/experiment/heap_figures.h"
#include "ui/language.h"
#include "ui/settings.h"

#include <QtCore/QLocale>
#include <QtCore/QSettings>
#include <QtWidgets/QApplication>

using namespace skyseal;
using namespace skyseal::app;

namespace {

/// Runs without a window system, which --help and usage errors do not need.
std::variant<WindowOptions, int> readCommandLine(int argc, char **argv)
{
    const QCoreApplication bare(argc, argv);
    return readOptions(QCoreApplication::arguments().mid(1));
}

} // namespace

int main(int argc, char **argv)
{
    protectKeysInMemory();
    QCoreApplication::setApplicationName(QStringLiteral("skyseal"));
    QCoreApplication::setOrganizationName(QStringLiteral("skyseal"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SKYSEAL_VERSION));
    auto options = readCommandLine(argc, argv);
    if (const int *status = std::get_if<int>(&options))
        return *status;

    const auto heap = std::make_shared<experiment::HeapFigures>(); // the window system starts threads
    QApplication application(argc, argv);
    const ui::WindowTranslation translation(
        ui::languageToUse(ui::storedLanguage(QSettings()), QLocale::system().uiLanguages()));
    QApplication::setApplicationDisplayName(QStringLiteral("Skyseal"));
    QApplication::setDesktopFileName(QStringLiteral("skyseal"));
    if (!crypto::initCrypto()) {
        complain(QStringLiteral("skyseal"), "the system provides no randomness");
        return kCannotOpen;
    }
    StopSignals signalled; // before links open: scripts may stop the program as soon as a link is open
    crypto::SystemRandom random;
    Application window(std::get<WindowOptions>(std::move(options)), random, heap);
    QObject::connect(&signalled, &StopSignals::stopRequested, &window, &Application::stop);
    if (!window.start())
        return kCannotOpen;
    return QApplication::exec();
}
