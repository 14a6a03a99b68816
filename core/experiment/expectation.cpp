#include "core/experiment/expectation.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr std::size_t kLongest = 1000;
constexpr int kDeepest = 32;

bool isWord(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

} // namespace

/// Recursive descent; the first problem ends it, as an exception that does not leave this file.
class ExpectationParser
{
public:
    explicit ExpectationParser(std::string_view text) : m_text(text) {}

    Expectation parse()
    {
        if (m_text.size() > kLongest)
            fail("longer than " + std::to_string(kLongest) + " characters");
        m_out.m_text = std::string(m_text);
        m_out.m_left = sum(0);
        m_out.m_relation = relation();
        m_out.m_right = sum(0);
        skipSpace();
        if (m_at != m_text.size())
            fail("unexpected " + here());
        const bool anyMetric = std::any_of(m_out.m_nodes.begin(), m_out.m_nodes.end(),
                                           [](const Node &node) { return node.kind == Kind::Value; });
        if (!anyMetric)
            fail("it mentions nothing that is measured");
        return std::move(m_out);
    }

private:
    using Kind = Expectation::Kind;
    using Node = Expectation::Node;
    using Relation = Expectation::Relation;

    [[noreturn]] void fail(const std::string &why) const { throw InputError{why, std::string(m_text), 1, m_at + 1}; }

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
    void expect(std::string_view token)
    {
        if (!take(token))
            fail("'" + std::string(token) + "' is expected instead of " + here());
    }
    std::size_t add(Node node)
    {
        m_out.m_nodes.push_back(node);
        return m_out.m_nodes.size() - 1;
    }
    std::size_t join(Kind kind, std::size_t left, std::size_t right)
    {
        Node node;
        node.kind = kind;
        node.left = left;
        node.right = right;
        return add(node);
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

    std::size_t sum(int depth)
    {
        std::size_t left = product(depth);
        for (;;) {
            if (take("+"))
                left = join(Kind::Add, left, product(depth));
            else if (take("-"))
                left = join(Kind::Subtract, left, product(depth));
            else
                return left;
        }
    }

    std::size_t product(int depth)
    {
        std::size_t left = factor(depth);
        for (;;) {
            if (take("*"))
                left = join(Kind::Multiply, left, factor(depth));
            else if (take("/"))
                left = join(Kind::Divide, left, factor(depth));
            else
                return left;
        }
    }

    std::size_t factor(int depth)
    {
        if (depth >= kDeepest)
            fail("nested too deeply");
        if (take("-"))
            return join(Kind::Negate, factor(depth + 1), 0);
        if (take("(")) {
            const std::size_t inside = sum(depth + 1);
            expect(")");
            return inside;
        }
        skipSpace();
        const char first = m_at < m_text.size() ? m_text[m_at] : '\0';
        if ((first >= '0' && first <= '9') || first == '.')
            return number();
        if (first >= 'a' && first <= 'z')
            return value();
        fail("a number or a metric is expected instead of " + here());
    }

    std::size_t number()
    {
        Node node;
        const char *begin = m_text.data() + m_at;
        const auto [end, error] = std::from_chars(begin, m_text.data() + m_text.size(), node.number);
        if (error != std::errc() || !std::isfinite(node.number))
            fail("not a number");
        m_at += static_cast<std::size_t>(end - begin);
        if (m_at < m_text.size() && isWord(m_text[m_at]))
            fail("unexpected " + here() + " behind a number");
        return add(node);
    }

    std::string_view word(bool withDashes)
    {
        skipSpace();
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && (isWord(m_text[m_at]) || (withDashes && m_text[m_at] == '-')))
            ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    std::size_t value()
    {
        Node node;
        node.kind = Kind::Value;
        const std::size_t begin = m_at;
        const std::string_view key = word(false);
        if (const auto metric = metricFromKey(key)) {
            node.metric = *metric;
        } else {
            m_at = begin;
            std::string names;
            for (const MetricInfo &one : metrics())
                names.append(names.empty() ? "" : ", ").append(one.key);
            fail("no metric is named '" + std::string(key) + "'; there are " + names);
        }
        if (take("("))
            arguments(node);
        if (!node.suite)
            m_out.m_forEachSuite = true;
        return add(node);
    }

    void arguments(Node &node)
    {
        if (!take("*"))
            node.suite = suite();
        while (take(","))
            loadOrFraming(node);
        expect(")");
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

    void loadOrFraming(Node &node)
    {
        skipSpace();
        const std::size_t begin = m_at;
        const std::string_view text = word(false);
        for (const Load known : {Load::Natural, Load::Saturated}) {
            if (text == name(known) && !node.load) {
                node.load = known;
                return;
            }
        }
        for (const channel::Framing known : {channel::Framing::Sealed, channel::Framing::Inline}) {
            if (text == name(known) && !node.framing) {
                node.framing = known;
                return;
            }
        }
        m_at = begin;
        fail("natural or saturated, sealed or inline is expected");
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    Expectation m_out;
};

Result<Expectation, InputError> Expectation::parse(std::string_view text)
{
    try {
        return ExpectationParser(text).parse();
    } catch (const InputError &error) {
        return tl::unexpected(error);
    }
}

std::vector<crypto::SuiteId> Expectation::suites() const
{
    std::vector<crypto::SuiteId> out;
    for (const Node &node : m_nodes) {
        if (node.kind == Kind::Value && node.suite)
            out.push_back(*node.suite);
    }
    return out;
}

std::vector<Load> Expectation::loads() const
{
    std::vector<Load> out;
    for (const Node &node : m_nodes) {
        if (node.kind == Kind::Value && node.load)
            out.push_back(*node.load);
    }
    return out;
}

std::vector<channel::Framing> Expectation::framings() const
{
    std::vector<channel::Framing> out;
    for (const Node &node : m_nodes) {
        if (node.kind == Kind::Value && node.framing)
            out.push_back(*node.framing);
    }
    return out;
}

std::optional<channel::Framing> Expectation::onlyFraming() const
{
    for (const Node &node : m_nodes) {
        if (node.kind == Kind::Value && !node.suite && node.framing)
            return node.framing;
    }
    return std::nullopt;
}

double Expectation::evaluate(std::size_t index, const SweepArm &subject, const Lookup &lookup) const
{
    const Node &node = m_nodes[index];
    const auto side = [&](std::size_t child) { return evaluate(child, subject, lookup); };
    switch (node.kind) {
    case Kind::Number: return node.number;
    case Kind::Value:
        return node.suite ? lookup(node.metric, *node.suite, node.framing, node.load)
                          : lookup(node.metric, subject.suite, node.framing.value_or(subject.framing), node.load);
    case Kind::Add: return side(node.left) + side(node.right);
    case Kind::Subtract: return side(node.left) - side(node.right);
    case Kind::Multiply: return side(node.left) * side(node.right);
    case Kind::Divide: return side(node.left) / side(node.right);
    case Kind::Negate: return -side(node.left);
    }
    return 0;
}

Expectation::Outcome Expectation::check(const SweepArm &subject, const Lookup &lookup) const
{
    Outcome out;
    out.left = evaluate(m_left, subject, lookup);
    out.right = evaluate(m_right, subject, lookup);
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
