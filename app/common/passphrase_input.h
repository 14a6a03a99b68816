// How the passphrase of a key file comes into a program: typed at the terminal without an echo, or from a file or an open
// descriptor. Never from the command line, which every user of the machine can read.
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
    /// A problem when both are given.
    static PassphraseInput read(Options &options, const char *which = "");

    /// True when a file or a descriptor was named.
    bool isGiven() const { return !m_file.empty() || m_descriptor >= 0; }

    /// For opening a sealed file. Asks at the terminal three times, a file or descriptor once.
    keys::AskPassphrase ask() const;
    /// One that belongs to no file; `question` is asked at the terminal where none is given.
    Result<crypto::Passphrase, InputError> once(const std::string &question) const;
    /// A new passphrase for `file`, typed twice at the terminal. An error in words when it was cancelled, empty or mistyped.
    Result<crypto::Passphrase, InputError> choose(const std::string &file) const;

private:
    Result<crypto::Passphrase, InputError> readGiven() const;

    std::string m_which; ///< what the options' names begin with
    std::string m_file;
    int m_descriptor = -1;
};

} // namespace skyseal::app
