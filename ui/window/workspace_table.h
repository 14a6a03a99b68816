// The table of the workspaces: arrangements of the same docks, each for one kind of work. Which panels a workspace shows is
// said by the rows of panelTable().
#pragma once

#include <array>
#include <cstddef>

namespace skyseal::ui {

/// Numbers of the rows of workspaceTable().
enum class Workspace { Fly, Plan, Vehicle, Lab };
inline constexpr std::size_t kWorkspaces = 4;

/// Sizes of the dock areas before the operator changes them. Side areas on which an instrument stands have a width of their
/// own; areas for tables and charts have a share of the window.
struct WorkspaceRow
{
    const char *id;    ///< saved arrangements refer to it
    const char *title; ///< in the translation context skyseal::ui::Workspaces
    int leftWidth;     ///< pixels
    int rightPercent;  ///< of the window's width
    int bottomPercent; ///< of the window's height
};

/// In the order of the keys Ctrl+1 … Ctrl+4.
const std::array<WorkspaceRow, kWorkspaces> &workspaceTable();

} // namespace skyseal::ui
