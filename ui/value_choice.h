// The values that the operator has chosen for the grid in Fly, and their text in the settings.
#pragma once

#include "ui/text/value_source.h"

#include <tl/expected.hpp>

#include <optional>
#include <vector>

namespace skyseal::ui {

/// Where a number lies between the limits of its value.
enum class LimitSide : std::uint8_t { Within, Low, High };

/// One value of the grid. Limits are in the metric unit in which the value is shown, whatever the operator's units are.
struct ValueChoice
{
    ValueSource source;
    QString caption = {};           ///< empty: that of the source
    int decimals = -1;              ///< < 0: those of the source
    std::optional<double> low = {}; ///< below it the value is "low"
    std::optional<double> high = {};
    bool line = false;     ///< of the last minute
    QString unitText = {}; ///< of a source without a unit

    QString shownCaption() const { return caption.isEmpty() ? source.caption() : caption; }
    /// The unit of the source, or the operator's text if it has none.
    ValueUnit shownUnit() const;
    /// On which side of the limits a number is; LimitSide::Within for NaN.
    LimitSide sideOf(double number) const;
    bool operator==(const ValueChoice &other) const;
};

using ValueChoices = std::vector<ValueChoice>;

inline constexpr std::size_t kMostValues = 32;
inline constexpr int kLongestCaption = 24; ///< characters
inline constexpr int kLongestUnit = 8;     ///< characters

/// Shown until the operator has chosen.
ValueChoices defaultValues();

/// JSON: [{"source": "alt_rel", "caption": "height", "decimals": 1, "low": 5, "high": 120, "line": true}, …]; a
/// source without a unit may have "unit": "l/h". All but the source may be missing.
QString toText(const ValueChoices &choices);

/// Reads the text of toText(). The error names the first entry that is not understood, and why.
tl::expected<ValueChoices, QString> readValueChoices(const QString &text);

/// The values as loaded from the settings.
struct ChosenValues
{
    ValueChoices list = defaultValues();
    QString problem = {}; ///< why the stored values are not used; empty if they are

    bool operator==(const ChosenValues &) const = default;
};

} // namespace skyseal::ui
