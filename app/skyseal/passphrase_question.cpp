#include "app/skyseal/passphrase_question.h"

#include "core/base/locked_memory.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "ui/keys/passphrase_dialog.h"
#include "ui/modeless.h"

#include <utility>

namespace skyseal::app {

namespace {

InputError notGiven(const std::string &file)
{
    return {sentence("Reason", "the passphrase was not given"), file};
}

} // namespace

PassphraseQuestion::~PassphraseQuestion()
{
    withdraw();
}

keys::AskPassphrase PassphraseQuestion::recalled()
{
    m_needed = false;
    return [this](const std::string &file, int attempt) -> Result<crypto::Passphrase, InputError> {
        if (attempt == 0 && m_memory.problem().isEmpty() && m_memory.remembers(file)) {
            if (auto known = m_memory.recall(file))
                return std::move(*known);
        }
        m_needed = true;
        return tl::unexpected(notGiven(file));
    };
}

void PassphraseQuestion::ask(QWidget &parent, const std::string &file, Opened opened, NotOpened notOpened)
{
    m_parent = &parent;
    m_file = file;
    m_opened = std::move(opened);
    m_notOpened = std::move(notOpened);
    if (m_dialog)
        ui::showModeless(*m_dialog);
    else
        showDialog(false);
}

void PassphraseQuestion::withdraw()
{
    if (!m_dialog)
        return;
    m_dialog->disconnect(this);
    m_dialog->close();
    m_dialog.clear();
}

void PassphraseQuestion::showDialog(bool again)
{
    m_dialog = new ui::PassphraseDialog(QString::fromStdString(m_file), again, m_memory.problem(), m_parent);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setToBeRemembered(m_memory.remembers(m_file)); // an outdated passphrase
    connect(m_dialog, &QDialog::accepted, this, &PassphraseQuestion::take);
    connect(m_dialog, &QDialog::rejected, this, [this] {
        m_dialog.clear();
        m_notOpened(notGiven(m_file));
    });
    ui::showModeless(*m_dialog);
}

void PassphraseQuestion::take()
{
    ui::PassphraseDialog &dialog = *std::exchange(m_dialog, nullptr);
    auto typed = dialog.takePassphrase();
    if (!typed)
        return m_notOpened(notGiven(m_file));
    const bool isToBeRemembered = dialog.isToBeRemembered();
    const auto passphrase = shareInLockedMemory(std::move(*typed));
    bool wrong = false;
    const auto opened = keys::loadIdentity(m_file,
                                           [&](const std::string &file, int attempt) -> Result<crypto::Passphrase, InputError> {
                                               wrong = attempt > 0;
                                               if (wrong)
                                                   return tl::unexpected(notGiven(file));
                                               return passphrase->clone();
                                           });
    if (wrong)
        return showDialog(true);
    if (!opened)
        return m_notOpened(opened.error());
    if (isToBeRemembered)
        m_memory.remember(m_file, *passphrase);
    else if (m_memory.problem().isEmpty() && m_memory.remembers(m_file))
        m_memory.forget(m_file);
    m_opened(passphrase);
}

} // namespace skyseal::app
