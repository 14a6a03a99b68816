#include "app/skyseal/passphrase_question.h"

#include "ui/keys/passphrase_dialog.h"

namespace skyseal::app {

Result<crypto::Passphrase, InputError> askInDialog(const std::string &file, int attempt)
{
    const InputError none{"the passphrase was not given", file};
    ui::PassphraseDialog dialog(QString::fromStdString(file), attempt > 0);
    if (dialog.exec() != QDialog::Accepted)
        return tl::unexpected(none);
    QByteArray typed = dialog.takePassphrase();
    auto passphrase = crypto::Passphrase::fromBytes(
        {reinterpret_cast<const std::uint8_t *>(typed.constData()), static_cast<std::size_t>(typed.size())});
    sodium_memzero(typed.data(), static_cast<std::size_t>(typed.size()));
    if (!passphrase)
        return tl::unexpected(none);
    return std::move(*passphrase);
}

} // namespace skyseal::app
