#include "core/experiment/expectation.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr std::size_t kLongest = 1000;

bool isWord(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

} // namespace

/// Reads from left to right. The first error is thrown and caught in Expectation::parse().
class ExpectationParser
{
public:
    explicit ExpectationParser(std::string_view text) : m_text(text) {}

    Expectation parse()
    {
        if (m_text.size() > kLongest)
            fail("longer than " + std::to_string(kLongest) + " characters");
        Expectation out;
        out.m_text = std::string(m_text);
        auto &[left, right] = out.m_sides;
        left = side();
        out.m_relation = relation();
        right = side();
        skipSpace();
        if (m_at != m_text.size())
            fail("unexpected " + here());
        if (!left.metric && !right.metric)
            fail("a metric is expected on one side");
        return out;
    }

private:
    using Relation = Expectation::Relation;
    using Side = Expectation::Side;

    [[noreturn]] void fail(const std::string &problem) const { throw InputError{problem, std::string(m_text), 1, m_at + 1}; }

    std::string here() const
    {
        return m_at < m_text.size() ? "'" + std::string(m_text.substr(m_at, 1)) + "'" : std::string("end");
    }
    void skipSpace()
    {
        while (m_at < m_text.size() && m_text[m_at] == ' ')
            ++m_at;
    }
    bool take(std::string_view token)
    {
        skipSpace();
        if (m_text.substr(m_at, token.size()) != token)
            return false;
        m_at += token.size();
        return true;
    }

    Relation relation()
    {
        constexpr std::pair<std::string_view, Relation> kRelations[] = {
            {"<=", Relation::LessOrEqual}, {">=", Relation::GreaterOrEqual},
            {"==", Relation::Equal},       {"!=", Relation::NotEqual},
            {"<", Relation::Less},         {">", Relation::Greater}};
        for (const auto &[sign, meaning] : kRelations) {
            if (take(sign))
                return meaning;
        }
        fail("a comparison (<=, >=, <, >, ==, !=) is expected instead of " + here());
    }

    Side side()
    {
        Side out;
        skipSpace();
        const char first = m_at < m_text.size() ? m_text[m_at] : '\0';
        if ((first >= '0' && first <= '9') || first == '.') {
            out.number = number();
            if (take("*"))
                metric(out);
        } else {
            metric(out);
        }
        return out;
    }

    double number()
    {
        double out = 0;
        const char *begin = m_text.data() + m_at;
        const auto [end, error] = std::from_chars(begin, m_text.data() + m_text.size(), out);
        if (error != std::errc() || !std::isfinite(out))
            fail("not a number");
        m_at += static_cast<std::size_t>(end - begin);
        if (m_at < m_text.size() && isWord(m_text[m_at]))
            fail("unexpected " + here() + " after a number");
        return out;
    }

    std::string_view word(bool withDashes)
    {
        skipSpace();
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && (isWord(m_text[m_at]) || (withDashes && m_text[m_at] == '-')))
            ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    void metric(Side &out)
    {
        skipSpace();
        const std::size_t begin = m_at;
        if (m_at == m_text.size() || m_text[m_at] < 'a' || m_text[m_at] > 'z')
            fail("a number or a metric is expected instead of " + here());
        const std::string_view key = word(false);
        out.metric = metricFromKey(key);
        if (!out.metric) {
            m_at = begin;
            std::string keys;
            for (const MetricInfo &one : metrics())
                keys.append(keys.empty() ? "" : ", ").append(one.key);
            fail("no metric is named '" + std::string(key) + "'; there are " + keys);
        }
        if (!take("("))
            return;
        if (!take("*"))
            out.suite = suite();
        while (take(","))
            loadOrFraming(out);
        if (!take(")"))
            fail("')' is expected instead of " + here());
    }

    crypto::SuiteId suite()
    {
        skipSpace();
        const std::size_t begin = m_at;
        const std::string_view text = word(true);
        const auto found = crypto::suiteFromName(text);
        if (!found) {
            m_at = begin;
            fail("no suite is named '" + std::string(text) + "'");
        }
        return *found;
    }

    void loadOrFraming(Side &out)
    {
        skipSpace();
        const std::size_t begin = m_at;
        const std::string_view text = word(false);
        if (const auto known = loadFromName(text); known && !out.load) {
            out.load = known;
            return;
        }
        for (const ArmFraming known : kFramings) {
            if (text == name(known) && !out.framing) {
                out.framing = known;
                return;
            }
        }
        m_at = begin;
        fail("natural, saturated or pps500, sealed, inline or bare is expected");
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

Result<Expectation, InputError> Expectation::parse(std::string_view text)
{
    try {
        return ExpectationParser(text).parse();
    } catch (const InputError &error) {
        return tl::unexpected(error);
    }
}

bool Expectation::isForEachSuite() const
{
    return std::any_of(m_sides.begin(), m_sides.end(), [](const Side &side) { return side.isForEachSuite(); });
}

std::vector<crypto::SuiteId> Expectation::suites() const
{
    std::vector<crypto::SuiteId> out;
    for (const Side &side : m_sides) {
        if (side.suite)
            out.push_back(*side.suite);
    }
    return out;
}

std::vector<Load> Expectation::loads() const
{
    std::vector<Load> out;
    for (const Side &side : m_sides) {
        if (side.load)
            out.push_back(*side.load);
    }
    return out;
}

std::vector<ArmFraming> Expectation::framings() const
{
    std::vector<ArmFraming> out;
    for (const Side &side : m_sides) {
        if (side.framing)
            out.push_back(*side.framing);
    }
    return out;
}

std::optional<ArmFraming> Expectation::onlyFraming() const
{
    for (const Side &side : m_sides) {
        if (side.isForEachSuite() && side.framing)
            return side.framing;
    }
    return std::nullopt;
}

double Expectation::Side::value(const SweepArm &arm, const Lookup &lookup) const
{
    if (!metric)
        return number;
    return number
        * (suite ? lookup(*metric, *suite, framing, load) : lookup(*metric, arm.suite, framing.value_or(arm.framing), load));
}

Expectation::Outcome Expectation::check(const SweepArm &arm, const Lookup &lookup) const
{
    Outcome out;
    out.left = m_sides[0].value(arm, lookup);
    out.right = m_sides[1].value(arm, lookup);
    out.measured = std::isfinite(out.left) && std::isfinite(out.right);
    if (!out.measured)
        return out;
    switch (m_relation) {
    case Relation::LessOrEqual: out.holds = out.left <= out.right; break;
    case Relation::GreaterOrEqual: out.holds = out.left >= out.right; break;
    case Relation::Less: out.holds = out.left < out.right; break;
    case Relation::Greater: out.holds = out.left > out.right; break;
    case Relation::Equal: out.holds = out.left == out.right; break;
    case Relation::NotEqual: out.holds = out.left != out.right; break;
    }
    return out;
}

} // namespace skyseal::experiment
