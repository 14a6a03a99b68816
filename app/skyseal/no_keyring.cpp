// The passphrase memory of a build without QtKeychain: it stores nothing.
#include "app/skyseal/passphrase_memory.h"

#include <QtCore/QCoreApplication>

#include <utility>

namespace skyseal::app {

namespace {

class NoMemory : public PassphraseMemory
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::app::NoMemory)

public:
    QString problem() const override { return tr("not included in this build"); }
    bool remembers(const std::string &) const override { return false; }
    void recall(const std::string &, QObject *context, Recalled recalled) override
    {
        QMetaObject::invokeMethod(
            context, [recalled = std::move(recalled)] { recalled(std::nullopt); }, Qt::QueuedConnection);
    }
    void remember(const std::string &, const crypto::Passphrase &) override {}
    void forget(const std::string &) override {}
};

} // namespace

std::unique_ptr<PassphraseMemory> desktopMemory(QSettings &)
{
    return std::make_unique<NoMemory>();
}

} // namespace skyseal::app
