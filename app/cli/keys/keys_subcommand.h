// The common parts of the subcommands of skyseal-cli keys.
#pragma once

#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"

#include <QtCore/QString>

namespace skyseal::app {

/// Usage: declare options, parse(), then report the result.
class KeysSubcommand
{
public:
    /// `subcommand`: as written after "skyseal-cli keys".
    KeysSubcommand(const char *subcommand, const char *help)
        : m_name(QStringLiteral("skyseal-cli keys ") + QLatin1String(subcommand)), options(m_name, QString::fromUtf8(help))
    {}

    /// Declares another positional argument; all are mandatory.
    void addArgument(const char *name, const char *help)
    {
        options.addArgument(name, help);
        ++m_arguments;
    }
    void addPeersOption() { options.addValue("peers", "FILE", "File of known peers; created if missing."); }
    void addJsonOption() { options.addFlag("json", "One JSON object per line on stdout."); }

    /// An exit status if the command is done already. Values of options are checked by options.finish().
    std::optional<int> parse(const QStringList &given)
    {
        if (const auto status = options.parse(given))
            return status;
        m_given = options.arguments(m_arguments, m_arguments);
        return std::nullopt;
    }
    std::string argument(int index) const { return m_given.value(index).toStdString(); }

    /// A file could not be opened, read or written.
    int cannotOpen(const InputError &error) const
    {
        complain(m_name, error.text());
        return kCannotOpen;
    }
    /// The files are valid, but the request is refused. The message may have several lines.
    int refuse(const std::string &message) const
    {
        const std::size_t end = message.find('\n');
        complain(m_name, message.substr(0, end));
        for (std::size_t begin = end; begin != std::string::npos;) {
            const std::size_t next = message.find('\n', begin + 1);
            remark(message.substr(begin + 1, next == std::string::npos ? next : next - begin - 1));
            begin = next;
        }
        return kNotReached;
    }

private:
    QString m_name;
    int m_arguments = 0;
    QStringList m_given;

public:
    Options options;
};

} // namespace skyseal::app
