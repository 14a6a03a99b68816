// Command line options of all programs: declared, parsed and checked alike, with one clear line and exit status 2 for
// anything that is wrong.
#pragma once

#include "core/crypto/suite.h"
#include "core/link/link_url.h"

#include <QtCore/QCommandLineParser>
#include <QtCore/QStringList>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::app {

/// Declare, parse(), read, and at the end ask finish(): the getters remember the first problem and go on, so that the
/// reading code stays a list.
class Options
{
public:
    /// `name` is what a person types: "skyseal-cli monitor".
    Options(QString name, const QString &description);

    void addFlag(const char *name, const char *help);
    void addValue(const char *name, const char *placeholder, const char *help, const char *preset = "");
    /// An option whose value is a link URL. Its help ends with the forms of the link types that `accepted` admits (all when
    /// it is null); url() and urls() refuse the others.
    using LinkFilter = bool (*)(const link::LinkTraits &);
    void addLink(const char *name, const char *help, LinkFilter accepted = nullptr, const char *preset = "");
    void addArgument(const char *name, const char *help);

    /// `arguments` without the program's name. An exit status when there is nothing more to do: help or version was printed,
    /// or the usage is wrong.
    std::optional<int> parse(const QStringList &arguments);
    /// kUsage when a getter or fail() found something wrong, after saying so.
    std::optional<int> finish() const;

    bool has(const char *name) const;
    std::string text(const char *name) const;
    /// A problem when it was not given.
    std::string required(const char *name);
    std::vector<std::string> texts(const char *name) const;
    /// A decimal number within [least, most].
    double number(const char *name, double least, double most);
    std::uint64_t wholeNumber(const char *name, std::uint64_t least, std::uint64_t most);
    /// A suite by its name.
    std::optional<crypto::SuiteId> suite(const char *name);
    /// Names separated by commas; "all" = every authenticated suite. None may come twice. `plainToo`: an error that lists the
    /// suites names plain MAVLink among them.
    std::vector<crypto::SuiteId> suites(const char *name, bool plainToo = false);
    /// A link that was declared with addLink(). A listening link whose host was left out listens on `unnamedHost`.
    std::optional<link::LinkUrl> url(const char *name, std::string_view unnamedHost = link::LinkUrl::kAnyHost);
    std::vector<link::LinkUrl> urls(const char *name);
    /// The positional arguments; a problem when there are fewer or more.
    QStringList arguments(int least, int most);

    void fail(const std::string &problem);

private:
    std::optional<crypto::SuiteId> suiteNamed(const std::string &option, const std::string &name, bool plainToo = false);
    std::optional<link::LinkUrl> parsedUrl(const std::string &option, const std::string &text,
                                           std::string_view unnamedHost = link::LinkUrl::kAnyHost);

    QString m_name;
    QCommandLineParser m_parser;
    std::map<std::string, LinkFilter> m_links; ///< by the name of their option
    std::string m_problem;
};

/// "skyseal-air: words", one line on stderr.
void complain(const QString &program, const std::string &words);

} // namespace skyseal::app
