#include "known_answers.h"

#include "core/base/hex.h"

#include <algorithm>
#include <fstream>

namespace skyseal::test {

namespace {

constexpr std::string_view kHeading = "Known answers";
constexpr std::string_view kIndent = "    ";

std::string trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos)
        return {};
    return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

} // namespace

KnownAnswers KnownAnswers::read(const std::string &path)
{
    KnownAnswers out;
    std::ifstream file(path);
    bool inside = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("## "))
            inside = line.ends_with(kHeading);
        else if (inside)
            out.take(line);
    }
    if (out.empty() && out.m_problem.empty())
        out.m_problem = path + " has no section \"" + std::string(kHeading) + "\"";
    return out;
}

void KnownAnswers::take(const std::string &line)
{
    if (!line.starts_with(kIndent)) {
        m_last.clear();
        return;
    }
    const std::size_t equals = line.find(" = ");
    const std::string value = trimmed(equals == std::string::npos ? line : line.substr(equals + 3));
    const std::string_view zeros = " | zeros ";
    const std::size_t filled = value.find(zeros);
    Bytes bytes;
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
        bytes.assign(value.begin() + 1, value.end() - 1);
    else if (const auto hex = fromHex(value.substr(0, filled)))
        bytes = *hex;
    else
        m_problem = "neither hex nor text: " + line;
    if (filled != std::string::npos)
        bytes.resize(bytes.size() + std::stoul(value.substr(filled + zeros.size())));
    if (equals == std::string::npos) {
        if (m_last.empty())
            m_problem = "continues nothing: " + line;
        else
            m_examples[m_last].insert(m_examples[m_last].end(), bytes.begin(), bytes.end());
        return;
    }
    m_last = trimmed(line.substr(0, equals));
    if (!m_examples.emplace(m_last, bytes).second)
        m_problem = "twice in the document: " + m_last;
}

const Bytes &KnownAnswers::operator[](const std::string &name) const
{
    static const Bytes kNone;
    m_asked.insert(name);
    const auto found = m_examples.find(name);
    return found == m_examples.end() ? kNone : found->second;
}

std::set<std::string> KnownAnswers::unused() const
{
    std::set<std::string> out;
    for (const auto &[name, bytes] : m_examples) {
        if (!m_asked.contains(name))
            out.insert(name);
    }
    return out;
}

} // namespace skyseal::test
