// Command line options of all programs: declaration, parsing and checks, with a one-line message and exit status 2 for each
// usage error.
#pragma once

#include "core/base/clock.h"
#include "core/crypto/suite.h"
#include "core/link/link_url.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCommandLineParser>
#include <QtCore/QStringList>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::app {

/// Usage: declare, parse(), read the values, then finish(). The getters record the first problem and continue, so that
/// callers need no error handling for each value.
class Options
{
public:
    /// `name`: the command as the user types it: "skyseal-cli monitor".
    Options(QString name, const QString &description);

    void addFlag(const char *name, const char *help);
    /// `preset`: the value without the option; the help ends with it.
    void addValue(const char *name, const char *placeholder, const char *help, const char *preset = "");
    /// An option whose value is a link URL. Its help ends with the forms of the link types that `accepted` admits (all when
    /// it is null); url() and urls() refuse the others.
    using LinkFilter = bool (*)(const link::LinkTraits &);
    void addLink(const char *name, const char *help, LinkFilter accepted = nullptr, const char *preset = "");
    void addArgument(const char *name, const char *help);
    /// --config: the other options may stand in a file (config_file.h). Those of the command line replace the file's.
    void addConfig();
    /// One of two options on the command line replaces the other one in the file as well. Whether both may be given at one
    /// place is for the caller to check.
    void addAlternatives(const char *one, const char *other);
    /// The same for options that exist for comparison only. A build without research does not know them (core/base/research.h):
    /// for it, has() is false and text() the preset.
    void addResearchFlag(const char *name, const char *help);
    void addResearchValue(const char *name, const char *placeholder, const char *help, const char *preset = "");

    /// `arguments`: without the program's name. Returns an exit status if the program is done: help or version was printed, or
    /// the usage is wrong.
    std::optional<int> parse(const QStringList &arguments);
    /// Prints the first problem and returns kUsage if a getter or fail() recorded one.
    std::optional<int> finish() const;

    bool has(const char *name) const;
    std::string text(const char *name) const;
    /// Records a problem if the option is missing.
    std::string required(const char *name);
    std::vector<std::string> texts(const char *name) const;
    /// A decimal number within [least, most].
    double number(const char *name, double least, double most);
    /// A decimal number of seconds within [least, most].
    Duration seconds(const char *name, double least, double most);
    std::uint64_t wholeNumber(const char *name, std::uint64_t least, std::uint64_t most);
    /// A suite by its name.
    std::optional<crypto::SuiteId> suite(const char *name);
    /// Names separated by commas; "all" = every authenticated suite. Repetitions are an error. `plainToo`: error messages
    /// list plain MAVLink among the suites.
    std::vector<crypto::SuiteId> suites(const char *name, bool plainToo = false);
    /// A link that was declared with addLink(). A listening link whose host was left out listens on `unnamedHost`.
    std::optional<link::LinkUrl> url(const char *name, std::string_view unnamedHost = link::LinkUrl::kAnyHost);
    std::vector<link::LinkUrl> urls(const char *name);
    /// The link that `text` describes, checked as a value of the option. For options whose value says more than a URL.
    std::optional<link::LinkUrl> parsedUrl(const std::string &option, const std::string &text,
                                           std::string_view unnamedHost = link::LinkUrl::kAnyHost);
    /// The positional arguments; records a problem if there are fewer or more.
    QStringList arguments(int least, int most);

    void fail(const std::string &problem);

private:
    std::optional<crypto::SuiteId> suiteNamed(const std::string &option, const std::string &name, bool plainToo = false);

    void declare(const QCommandLineOption &option);
    std::optional<int> parseWithConfig(const QStringList &arguments);
    Result<QStringList, InputError> argumentsOf(const std::string &configFile) const;

    QString m_name;
    QCommandLineParser m_parser;
    std::map<QString, bool> m_declared;        ///< option names; true if the option takes a value
    std::map<QString, QString> m_alternatives; ///< see addAlternatives(), both ways
    std::map<std::string, LinkFilter> m_links; ///< by the name of their option
    std::map<std::string, std::string> m_left; ///< presets of the options that this build does not know
    std::string m_problem;
};

/// For Options::addLink(): any link except recordings, which only replay.
bool isLive(const link::LinkTraits &traits);

/// Prints "skyseal-air: message", one line on stderr, where that is the journal with this severity.
void complain(const QString &program, const std::string &text, unsigned severity = mavlink::MAV_SEVERITY_ERROR);

} // namespace skyseal::app
