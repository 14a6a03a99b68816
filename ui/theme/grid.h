// The 8 px grid on which everything stands.
#pragma once

namespace skyseal::ui {

inline constexpr int kGrid = 8;
inline constexpr int kHalfGrid = 4;
inline constexpr int kRow = 22; ///< height of a row of numbers

} // namespace skyseal::ui
