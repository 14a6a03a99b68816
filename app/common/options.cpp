#include "app/common/options.h"

#include "app/common/config_file.h"
#include "app/common/exit_status.h"
#include "app/common/journal.h"
#include "app/common/output.h"
#include "core/base/number_text.h"
#include "core/base/research.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace skyseal::app {

namespace {

std::string quoted(const std::string &text)
{
    return "'" + text + "'";
}

std::vector<std::string> splitByComma(const std::string &text)
{
    std::vector<std::string> out;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        out.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

std::string suiteNames(bool plainToo)
{
    std::string out;
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        if (info.authenticated || (plainToo && info.id == crypto::SuiteId::None))
            out.append(out.empty() ? "" : ", ").append(info.name);
    }
    return out;
}

template<typename T> std::optional<T> parsed(const std::string &text)
{
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

constexpr const char *kConfig = "config";

} // namespace

bool isLive(const link::LinkTraits &traits)
{
    return !traits.isRecording;
}

void complain(const QString &program, const std::string &text, unsigned severity)
{
    remark(program.toStdString() + ": " + text, severity);
}

Options::Options(QString name, const QString &description) : m_name(std::move(name))
{
    m_parser.setApplicationDescription(description);
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    m_parser.addOption({{QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Show this help.")});
    m_parser.addOption({QStringLiteral("version"), QStringLiteral("Show the version.")});
}

void Options::addFlag(const char *name, const char *help)
{
    declare({QLatin1String(name), QString::fromUtf8(help)});
}

void Options::addValue(const char *name, const char *placeholder, const char *help, const char *preset)
{
    const QString stated = *preset ? QStringLiteral(" Default: %1.").arg(QLatin1String(preset)) : QString();
    declare({QLatin1String(name), QString::fromUtf8(help) + stated, QLatin1String(placeholder), QLatin1String(preset)});
}

void Options::declare(const QCommandLineOption &option)
{
    m_parser.addOption(option);
    m_declared[option.names().front()] = !option.valueName().isEmpty();
}

void Options::addConfig()
{
    addValue(kConfig, "FILE",
             "Read further options from a file with one NAME = VALUE per line; a flag has the value yes or no.");
}

void Options::addAlternatives(const char *one, const char *other)
{
    m_alternatives[QLatin1String(one)] = QLatin1String(other);
    m_alternatives[QLatin1String(other)] = QLatin1String(one);
}

void Options::addLink(const char *name, const char *help, LinkFilter accepted, const char *preset)
{
    m_links[name] = accepted;
    addValue(name, "URL", (std::string(help) + " Forms: " + link::linkForms(accepted) + ".").c_str(), preset);
}

void Options::addArgument(const char *name, const char *help)
{
    m_parser.addPositionalArgument(QLatin1String(name), QString::fromUtf8(help), QLatin1String(name));
}

void Options::addResearchFlag(const char *name, const char *help)
{
    if (kResearch)
        addFlag(name, help);
    else
        m_left[name];
}

void Options::addResearchValue(const char *name, const char *placeholder, const char *help, const char *preset)
{
    if (kResearch)
        addValue(name, placeholder, help, preset);
    else
        m_left[name] = preset;
}

std::optional<int> Options::parse(const QStringList &arguments)
{
    // The parser expects the program's name first and shows it in the help.
    if (!m_parser.parse(QStringList{m_name} + arguments)) {
        complain(m_name, m_parser.errorText().section(QLatin1Char('\n'), 0, 0).toStdString());
        return kUsage;
    }
    if (m_parser.isSet(QStringLiteral("help"))) {
        QString help = m_parser.helpText();
        const QString program = QCoreApplication::arguments().value(0);
        // Only in the line of usage: if the program was started by its name alone, other lines may have the same word.
        if (const qsizetype at = help.indexOf(program); !program.isEmpty() && at >= 0)
            help.replace(at, program.size(), m_name);
        std::fputs(help.toUtf8().constData(), stdout);
        return kDone;
    }
    if (m_parser.isSet(QStringLiteral("version"))) {
        std::printf("%s " SKYSEAL_VERSION "\n", qPrintable(m_name.section(QLatin1Char(' '), 0, 0)));
        return kDone;
    }
    return m_declared.contains(QLatin1String(kConfig)) && has(kConfig) ? parseWithConfig(arguments) : std::nullopt;
}

std::optional<int> Options::parseWithConfig(const QStringList &arguments)
{
    const auto fromFile = argumentsOf(text(kConfig));
    if (!fromFile) {
        complain(m_name, fromFile.error().text());
        return fromFile.error().line ? kUsage : kCannotOpen;
    }
    m_parser.parse(QStringList{m_name} + *fromFile + arguments); // each part alone is valid
    return std::nullopt;
}

/// The options of the file that the command line leaves open.
Result<QStringList, InputError> Options::argumentsOf(const std::string &configFile) const
{
    const auto lines = readConfig(configFile);
    if (!lines)
        return tl::unexpected(lines.error());
    QStringList out;
    for (const ConfigLine &line : *lines) {
        const auto wrong = [&](const std::string &problem) {
            return tl::unexpected(InputError{problem, configFile, line.number, 0});
        };
        const QString name = QString::fromStdString(line.name);
        const auto declared = m_declared.find(name);
        if (declared == m_declared.end() || line.name == kConfig)
            return wrong("no option is named " + quoted(line.name));
        const bool isFlag = !declared->second;
        if (isFlag && line.value != "yes" && line.value != "no")
            return wrong(line.name + " " + quoted(line.value) + ": yes or no is expected");
        const auto alternative = m_alternatives.find(name);
        const bool isReplaced = m_parser.isSet(name)
            || (alternative != m_alternatives.end() && m_parser.isSet(alternative->second));
        if (isReplaced || (isFlag && line.value == "no"))
            continue;
        out << QStringLiteral("--") + name + (isFlag ? QString() : QLatin1Char('=') + QString::fromStdString(line.value));
    }
    return out;
}

std::optional<int> Options::finish() const
{
    if (m_problem.empty())
        return std::nullopt;
    complain(m_name, m_problem);
    return kUsage;
}

bool Options::has(const char *name) const
{
    return !m_left.contains(name) && m_parser.isSet(QLatin1String(name));
}

std::string Options::text(const char *name) const
{
    const auto left = m_left.find(name);
    return left != m_left.end() ? left->second : m_parser.value(QLatin1String(name)).toStdString();
}

std::string Options::required(const char *name)
{
    if (!has(name) || text(name).empty())
        fail(std::string("--") + name + " is missing");
    return text(name);
}

std::vector<std::string> Options::texts(const char *name) const
{
    std::vector<std::string> out;
    for (const QString &value : m_parser.values(QLatin1String(name)))
        out.push_back(value.toStdString());
    return out;
}

double Options::number(const char *name, double least, double most)
{
    const std::string given = text(name);
    const std::optional<double> value = parsed<double>(given);
    if (!value || !std::isfinite(*value) || *value < least || *value > most) {
        fail(std::string("--") + name + " " + quoted(given) + ": a number from " + significantText(least, 6) + " to "
             + significantText(most, 6) + " is expected");
        return least;
    }
    return *value;
}

Duration Options::seconds(const char *name, double least, double most)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(number(name, least, most)));
}

std::uint64_t Options::wholeNumber(const char *name, std::uint64_t least, std::uint64_t most)
{
    const std::string given = text(name);
    const std::optional<std::uint64_t> value = parsed<std::uint64_t>(given);
    if (!value || *value < least || *value > most) {
        fail(std::string("--") + name + " " + quoted(given) + ": a whole number from " + std::to_string(least) + " to "
             + std::to_string(most) + " is expected");
        return least;
    }
    return *value;
}

std::optional<crypto::SuiteId> Options::suiteNamed(const std::string &option, const std::string &name, bool plainToo)
{
    const std::optional<crypto::SuiteId> id = crypto::suiteFromName(name);
    if (!id) {
        fail("--" + option + ": no suite is named " + quoted(name) + "; there are " + suiteNames(plainToo));
        return std::nullopt;
    }
    return id;
}

std::optional<crypto::SuiteId> Options::suite(const char *name)
{
    return suiteNamed(name, text(name));
}

std::vector<crypto::SuiteId> Options::suites(const char *name, bool plainToo)
{
    std::vector<crypto::SuiteId> out;
    const std::string list = text(name);
    if (list == "all") {
        for (const crypto::SuiteInfo &info : crypto::suites()) {
            if (info.authenticated)
                out.push_back(info.id);
        }
        return out;
    }
    for (const std::string &item : splitByComma(list)) {
        const std::optional<crypto::SuiteId> id = suiteNamed(name, item, plainToo);
        if (!id)
            return out;
        if (std::find(out.begin(), out.end(), *id) != out.end())
            fail(std::string("--") + name + ": " + quoted(item) + " is listed twice");
        out.push_back(*id);
    }
    return out;
}

std::optional<link::LinkUrl> Options::parsedUrl(const std::string &option, const std::string &text,
                                                std::string_view unnamedHost)
{
    auto parsedText = link::LinkUrl::parse(text, unnamedHost);
    if (!parsedText) {
        fail("--" + option + " " + quoted(text) + ": " + parsedText.error().message.text());
        return std::nullopt;
    }
    const LinkFilter accepted = m_links.at(option);
    if (accepted && !accepted(parsedText->traits())) {
        fail("--" + option + " " + quoted(text) + ": " + link::linkForms(accepted) + " is expected");
        return std::nullopt;
    }
    return std::move(*parsedText);
}

std::optional<link::LinkUrl> Options::url(const char *name, std::string_view unnamedHost)
{
    const std::string given = text(name); // or the preset
    if (given.empty())
        fail(std::string("--") + name + " is missing");
    return given.empty() ? std::nullopt : parsedUrl(name, given, unnamedHost);
}

std::vector<link::LinkUrl> Options::urls(const char *name)
{
    std::vector<link::LinkUrl> out;
    for (const std::string &given : texts(name)) {
        if (const auto link = parsedUrl(name, given))
            out.push_back(*link);
    }
    return out;
}

QStringList Options::arguments(int least, int most)
{
    QStringList given = m_parser.positionalArguments();
    if (given.size() > most)
        fail("unexpected argument " + quoted(given[most].toStdString()));
    else if (given.size() < least)
        fail("an argument is missing; --help shows which");
    return given;
}

void Options::fail(const std::string &problem)
{
    if (m_problem.empty())
        m_problem = problem;
}

} // namespace skyseal::app
