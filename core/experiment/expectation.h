// Assertions about a sweep, for scripts: "loss<=0.001", "cpu(chacha20-poly1305)<=1.10*cpu(none)".
//
//   assertion = side ("<=" | ">=" | "<" | ">" | "==" | "!=") side
//   side      = number | [number "*"] metric ["(" (suite | "*") {"," (load | framing)} ")"]
//
// At least one side names a metric. A metric stands for its mean over the repeats. Without a suite, or with "*" for it, the
// assertion must hold for each suite in turn. The load is "natural" or "saturated"; an assertion that names none must hold
// under each load of the sweep; beside a metric with a load, a metric without one uses the first load of the sweep. The framing
// is "sealed", "inline" or "bare"; without one, a metric with a suite uses the first framing of the sweep, and a metric without
// a suite each in turn.
#pragma once

#include "core/base/result.h"
#include "core/crypto/suite.h"
#include "core/experiment/metric.h"
#include "core/experiment/plan.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

class Expectation
{
public:
    /// The error names the problem and its column, counted in bytes from 1.
    static Result<Expectation, InputError> parse(std::string_view text);

    const std::string &text() const { return m_text; }
    /// True if a metric names no suite: the assertion is checked for each suite in turn.
    bool isForEachSuite() const;
    /// True if no metric names a load: the assertion is checked for each load in turn.
    bool isForEachLoad() const { return loads().empty(); }
    /// The suites, loads and framings that it names. The sweep must measure them, see fits().
    std::vector<crypto::SuiteId> suites() const;
    std::vector<Load> loads() const;
    std::vector<ArmFraming> framings() const;
    /// The framing of a metric without a suite, such as cpu(*,inline); nullopt without one.
    std::optional<ArmFraming> onlyFraming() const;

    /// Returns the mean of a metric; NaN if it was not measured.
    using Lookup = std::function<double(Metric, crypto::SuiteId, std::optional<ArmFraming>, std::optional<Load>)>;
    struct Outcome
    {
        bool measured = false; ///< both sides are finite
        bool holds = false;    ///< false unless measured
        double left = 0, right = 0;
    };
    /// `arm` supplies the suite and the framing of metrics that name none.
    Outcome check(const SweepArm &arm, const Lookup &lookup) const;

private:
    friend class ExpectationParser;

    enum class Relation : std::uint8_t { LessOrEqual, GreaterOrEqual, Less, Greater, Equal, NotEqual };
    struct Side
    {
        double number = 1;            ///< the factor of the metric; without a metric the value itself
        std::optional<Metric> metric; ///< nullopt: only a number
        std::optional<crypto::SuiteId> suite;
        std::optional<Load> load;
        std::optional<ArmFraming> framing;

        bool isForEachSuite() const { return metric && !suite; }
        double value(const SweepArm &arm, const Lookup &lookup) const;
    };

    std::string m_text;
    std::array<Side, 2> m_sides; ///< left, right
    Relation m_relation{};
};

} // namespace skyseal::experiment
