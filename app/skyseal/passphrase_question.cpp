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
    if (file != m_file)
        withdraw(); // it was about another key
    m_parent = &parent;
    m_file = file;
    m_opened = std::move(opened);
    m_notOpened = std::move(notOpened);
    if (m_dialog)
        ui::showModeless(*m_dialog);
    else if (!m_opening)
        showDialog(false);
}

void PassphraseQuestion::withdraw()
{
    ++m_number;
    m_opening = false;
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
    const auto passphrase = shareInLockedMemory(std::move(*typed));
    m_opening = true;
    m_thread.run(
        this, [file = m_file, passphrase] { return open(file, *passphrase); },
        [this, passphrase, number = ++m_number, remember = dialog.isToBeRemembered()](const Outcome &outcome) {
            if (number == m_number && m_parent)
                finish(outcome, *passphrase, remember);
        });
}

/// Thread-safe.
PassphraseQuestion::Outcome PassphraseQuestion::open(const std::string &file, const crypto::Passphrase &passphrase)
{
    bool wrong = false;
    auto identity = keys::loadIdentity(file,
                                       [&](const std::string &name, int attempt) -> Result<crypto::Passphrase, InputError> {
                                           wrong = attempt > 0;
                                           if (wrong)
                                               return tl::unexpected(notGiven(name));
                                           return passphrase.clone();
                                       });
    return {std::move(identity).map([](crypto::X25519KeyPair &&pair) { return shareInLockedMemory(std::move(pair)); }), wrong};
}

void PassphraseQuestion::finish(const Outcome &outcome, const crypto::Passphrase &passphrase, bool isToBeRemembered)
{
    m_opening = false;
    if (outcome.wrong)
        return showDialog(true);
    if (!outcome.identity)
        return m_notOpened(outcome.identity.error());
    if (isToBeRemembered)
        m_memory.remember(m_file, passphrase);
    else if (m_memory.problem().isEmpty() && m_memory.remembers(m_file))
        m_memory.forget(m_file);
    m_opened(*outcome.identity);
}

} // namespace skyseal::app
