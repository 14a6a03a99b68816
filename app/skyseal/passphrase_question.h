// Provides the passphrase of a sealed key to the reader of key files: from the desktop's keyring if it is stored there,
// otherwise from the operator.
#pragma once

#include "app/skyseal/passphrase_memory.h"
#include "core/keys/secret_file.h"

#include <memory>
#include <string>

namespace skyseal::app {

class PassphraseQuestion
{
public:
    /// `memory` must outlive this.
    explicit PassphraseQuestion(PassphraseMemory &memory) : m_memory(memory) {}

    /// Returns a function that asks until the file opens or the operator cancels. It blocks on the GUI thread and must not
    /// outlive this.
    keys::AskPassphrase ask();
    /// True if the operator cancelled.
    bool declined() const { return m_declined; }
    /// The last answer opened the file: stores the passphrase if the operator chose so.
    void opened();

private:
    Result<crypto::Passphrase, InputError> answer(const std::string &file, int attempt);

    PassphraseMemory &m_memory;
    std::string m_file;
    std::shared_ptr<const crypto::Passphrase> m_toRemember;
    bool m_forget = false;
    bool m_declined = false;
};

} // namespace skyseal::app
