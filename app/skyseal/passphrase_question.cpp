#include "app/skyseal/passphrase_question.h"

#include "core/base/locked_memory.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "ui/modeless.h"

#include <utility>

namespace skyseal::app {

PassphraseQuestion::~PassphraseQuestion()
{
    withdraw();
}

InputError PassphraseQuestion::notGiven(const std::string &file)
{
    return {sentence("Reason", "the passphrase was not given"), file};
}

bool PassphraseQuestion::isRemembered(const std::string &file) const
{
    return m_memory.problem().isEmpty() && m_memory.remembers(file);
}

void PassphraseQuestion::recall(QWidget &parent, const std::string &file, Opened opened, NotOpened notOpened, Unknown unknown)
{
    withdraw();
    m_parent = &parent;
    m_file = file;
    m_opened = std::move(opened);
    m_notOpened = std::move(notOpened);
    m_unknown = std::move(unknown);
    setOpening(true);
    m_memory.recall(file, this, [this, number = ++m_number](std::optional<crypto::Passphrase> found) {
        if (number != m_number || !m_parent)
            return;
        if (found)
            return hash(std::move(*found), [this](const Outcome &outcome, const auto &) { finishRecalled(outcome); });
        setOpening(false);
        m_unknown(false);
    });
}

void PassphraseQuestion::ask(QWidget &parent, const std::string &file, Opened opened, NotOpened notOpened,
                             ui::RefusedPassphrase refused)
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
        showDialog(refused);
}

void PassphraseQuestion::withdraw()
{
    ++m_number;
    setOpening(false);
    if (!m_dialog)
        return;
    m_dialog->disconnect(this);
    m_dialog->close();
    m_dialog.clear();
}

void PassphraseQuestion::showDialog(ui::RefusedPassphrase refused)
{
    m_dialog = new ui::PassphraseDialog(QString::fromStdString(m_file), refused, m_memory.problem(), m_parent);
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
    hash(std::move(*typed),
         [this, remember = dialog.isToBeRemembered()](const Outcome &outcome, const crypto::Passphrase &passphrase) {
             finishTyped(outcome, passphrase, remember);
         });
}

void PassphraseQuestion::hash(crypto::Passphrase given, Hashed hashed)
{
    const auto passphrase = shareInLockedMemory(std::move(given));
    setOpening(true);
    m_thread.run(
        this, [file = m_file, passphrase] { return open(file, *passphrase); },
        [this, passphrase, number = ++m_number, hashed = std::move(hashed)](const Outcome &outcome) {
            if (number != m_number || !m_parent)
                return;
            setOpening(false);
            hashed(outcome, *passphrase);
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

void PassphraseQuestion::finishRecalled(const Outcome &outcome)
{
    if (outcome.wrong)
        return m_unknown(true);
    if (!outcome.identity)
        return m_notOpened(outcome.identity.error());
    m_opened(*outcome.identity);
}

void PassphraseQuestion::finishTyped(const Outcome &outcome, const crypto::Passphrase &passphrase, bool isToBeRemembered)
{
    if (outcome.wrong)
        return showDialog(ui::RefusedPassphrase::Typed);
    if (!outcome.identity)
        return m_notOpened(outcome.identity.error());
    if (isToBeRemembered)
        m_memory.remember(m_file, passphrase);
    else if (m_memory.problem().isEmpty() && m_memory.remembers(m_file))
        m_memory.forget(m_file);
    m_opened(*outcome.identity);
}

void PassphraseQuestion::setOpening(bool opening)
{
    if (std::exchange(m_opening, opening) != opening)
        Q_EMIT openingChanged(opening);
}

} // namespace skyseal::app

#include "moc_passphrase_question.cpp"
