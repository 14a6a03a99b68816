// Where the pages of a report begin and end. A report is laid out as one long column; no line and no row of a table is
// divided, a heading stays with what follows it, and the head of a table is repeated above its rows on the next page. Pure
// function.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace skyseal::app {

/// A line of text or a row of a table, from top to bottom of the column.
struct PageUnit
{
    double top = 0, bottom = 0;
    std::optional<std::size_t> table; ///< whose row it is
    bool keepsNext = false;           ///< no page ends after it
    bool beginsPage = false;
};

struct TableExtent
{
    double top = 0, headBottom = 0, bottom = 0; ///< the head begins at the top

    double headHeight() const { return headBottom - top; }
};

/// A part of the column that is one page.
struct PageSlice
{
    double top = 0, bottom = 0;
    std::optional<std::size_t> head; ///< of that table, above the slice
};

/// Tables of up to half of `height` stay whole. A unit that is higher than a page is divided.
std::vector<PageSlice> paginate(const std::vector<PageUnit> &units, const std::vector<TableExtent> &tables, double height);

} // namespace skyseal::app
