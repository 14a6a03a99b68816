#include "app/skyseal/passphrase_question.h"

#include "core/base/locked_memory.h"
#include "core/crypto/passphrase.h"
#include "ui/keys/passphrase_dialog.h"

namespace skyseal::app {

keys::AskPassphrase PassphraseQuestion::ask()
{
    return [this](const std::string &file, int attempt) { return answer(file, attempt); };
}

Result<crypto::Passphrase, InputError> PassphraseQuestion::answer(const std::string &file, int attempt)
{
    m_toRemember.reset();
    m_file = file;
    m_forget = false;
    const QString problem = m_memory.problem();
    if (attempt == 0 && problem.isEmpty() && m_memory.remembers(file)) {
        if (auto recalled = m_memory.recall(file))
            return std::move(*recalled);
    }
    ui::PassphraseDialog dialog(QString::fromStdString(file), attempt > 0, problem);
    dialog.setToBeRemembered(m_memory.remembers(file)); // an outdated passphrase
    const InputError none{"the passphrase was not given", file};
    m_declined = dialog.exec() != QDialog::Accepted;
    if (m_declined)
        return tl::unexpected(none);
    auto passphrase = dialog.takePassphrase();
    if (!passphrase)
        return tl::unexpected(none);
    if (dialog.isToBeRemembered())
        m_toRemember = shareInLockedMemory(passphrase->clone());
    else
        m_forget = problem.isEmpty() && m_memory.remembers(file);
    return std::move(*passphrase);
}

void PassphraseQuestion::opened()
{
    if (m_toRemember)
        m_memory.remember(m_file, *m_toRemember);
    else if (m_forget)
        m_memory.forget(m_file);
    m_forget = false;
    m_toRemember.reset();
}

} // namespace skyseal::app
