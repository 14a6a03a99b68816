// Assertions about a sweep, for scripts: "loss<=0.001", "cpu(chacha20-poly1305)<=1.10*cpu(none)".
//
//   comparison = sum ("<=" | ">=" | "<" | ">" | "==" | "!=") sum
//   sum        = product {("+" | "-") product}
//   product    = factor {("*" | "/") factor}
//   factor     = number | metric ["(" suite {"," (load | framing)} ")"] | "(" sum ")" | "-" factor
//
// A metric stands for its mean over the repeats. Without a suite, or with "*" for it, it stands for every suite in turn, and
// the comparison must hold for each of them. The load is "natural" or "saturated"; a comparison that names none must hold
// under each load of the sweep; beside a metric with a load, one without stands for the sweep's first. The framing is "sealed"
// or "inline"; without one, the first of the sweep for a suite that is named, and each in turn otherwise.
#pragma once

#include "core/base/result.h"
#include "core/crypto/suite.h"
#include "core/experiment/metric.h"
#include "core/experiment/plan.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

class Expectation
{
public:
    /// An error says what is wrong and at which column.
    static Result<Expectation, InputError> parse(std::string_view text);

    const std::string &text() const { return m_text; }
    /// Whether it holds for one suite at a time.
    bool isForEachSuite() const { return m_forEachSuite; }
    /// Whether it holds for one load at a time: it names none.
    bool isForEachLoad() const { return loads().empty(); }
    /// Suites and loads that it names: a sweep must have them.
    std::vector<crypto::SuiteId> suites() const;
    std::vector<Load> loads() const;
    std::vector<channel::Framing> framings() const;
    /// The framing that it restricts its suites to, where it stands for every suite.
    std::optional<channel::Framing> onlyFraming() const;

    /// The mean of a metric; NaN when it was not measured.
    using Lookup = std::function<double(Metric, crypto::SuiteId, std::optional<channel::Framing>, std::optional<Load>)>;
    struct Outcome
    {
        bool measured = false; ///< both sides are numbers
        bool holds = false;
        double left = 0, right = 0;
    };
    /// `subject` is what metrics without a suite stand for.
    Outcome check(const SweepArm &subject, const Lookup &lookup) const;

private:
    friend class ExpectationParser;

    enum class Kind : std::uint8_t { Number, Value, Add, Subtract, Multiply, Divide, Negate };
    enum class Relation : std::uint8_t { LessOrEqual, GreaterOrEqual, Less, Greater, Equal, NotEqual };
    struct Node
    {
        Kind kind{};
        double number = 0;
        Metric metric{};
        std::optional<crypto::SuiteId> suite;
        std::optional<Load> load;
        std::optional<channel::Framing> framing;
        std::size_t left = 0, right = 0; ///< indices of nodes
    };

    double evaluate(std::size_t node, const SweepArm &subject, const Lookup &lookup) const;

    std::string m_text;
    std::vector<Node> m_nodes;
    std::size_t m_left = 0, m_right = 0;
    Relation m_relation{};
    bool m_forEachSuite = false;
};

} // namespace skyseal::experiment
