// The passphrase memory of a build without QtKeychain: it stores nothing.
#include "app/skyseal/passphrase_memory.h"

#include <QtCore/QCoreApplication>

namespace skyseal::app {

namespace {

class NoMemory : public PassphraseMemory
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::app::NoMemory)

public:
    QString problem() const override { return tr("not included in this build"); }
    bool remembers(const std::string &) const override { return false; }
    std::optional<crypto::Passphrase> recall(const std::string &) override { return std::nullopt; }
    void remember(const std::string &, const crypto::Passphrase &) override {}
    void forget(const std::string &) override {}
};

} // namespace

std::unique_ptr<PassphraseMemory> desktopMemory(QSettings &)
{
    return std::make_unique<NoMemory>();
}

} // namespace skyseal::app
