// The 8 px grid on which everything stands.
#pragma once

namespace skyseal::ui {

inline constexpr int kGrid = 8;
inline constexpr int kHalfGrid = 4;
inline constexpr int kTouchTarget = 44; ///< least side of what a finger has to hit, as of WCAG 2.5.5
inline constexpr int kRow = 22;         ///< height of a row of numbers

} // namespace skyseal::ui
