// Reads the passphrase of a key file: from the terminal without echo, a file or an open descriptor. Never from the command
// line, which every user of the machine can read.
#pragma once

#include "app/common/options.h"
#include "core/keys/secret_file.h"

#include <string>

namespace skyseal::app {

class PassphraseInput
{
public:
    /// Declares --passphrase-file and --passphrase-fd; with `which`, e.g. "new-", --new-passphrase-file and so on. `whose` is
    /// for the help: "the key's passphrase". A file "-" is standard input, of which one line is read.
    static void declare(Options &options, const char *which = "", const char *whose = "the key's passphrase");
    /// Records a problem if both are given.
    static PassphraseInput read(Options &options, const char *which = "");

    /// True if a file or a descriptor is given.
    bool isGiven() const { return !m_file.empty() || m_descriptor >= 0; }

    /// For opening a sealed file. Asks at the terminal three times, a file or descriptor once.
    keys::AskPassphrase ask() const;
    /// A passphrase that does not belong to a file; `question` is the prompt at the terminal.
    Result<crypto::Passphrase, InputError> once(const std::string &question) const;
    /// A new passphrase for `file`, entered twice at the terminal. An error if it was cancelled, empty or different.
    Result<crypto::Passphrase, InputError> choose(const std::string &file) const;

private:
    Result<crypto::Passphrase, InputError> readGiven() const;

    std::string m_which; ///< prefix of the options' names
    std::string m_file;
    int m_descriptor = -1;
};

} // namespace skyseal::app
