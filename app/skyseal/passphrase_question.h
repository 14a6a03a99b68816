// Asks for the passphrase of a sealed key as the reader of key files wants it: the desktop's keyring first, if it was to remember
// it, then the operator.
#pragma once

#include "app/skyseal/passphrase_memory.h"
#include "core/keys/secret_file.h"

namespace skyseal::app {

class PassphraseQuestion
{
public:
    /// `memory` must outlive it.
    explicit PassphraseQuestion(PassphraseMemory &memory) : m_memory(memory) {}

    /// Asks until the file opens or the operator gives up. GUI thread; waits for the answer. The function must not outlive this.
    keys::AskPassphrase ask()
    {
        return [this](const std::string &file, int attempt) { return answer(file, attempt); };
    }
    /// The operator was asked and did not answer.
    bool declined() const { return m_declined; }
    /// The last answer opened the file: what the operator wanted remembered is remembered.
    void opened();

private:
    Result<crypto::Passphrase, InputError> answer(const std::string &file, int attempt);

    PassphraseMemory &m_memory;
    std::string m_file;
    std::optional<crypto::Passphrase> m_toRemember;
    bool m_forget = false;
    bool m_declined = false;
};

} // namespace skyseal::app
