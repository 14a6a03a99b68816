#include "app/figures/pagination.h"

#include <algorithm>

namespace skyseal::app {

namespace {

constexpr double kRounding = 1e-3;

class Paginator
{
public:
    Paginator(const std::vector<PageUnit> &units, const std::vector<TableExtent> &tables, double height)
        : m_units(units), m_tables(tables), m_height(height)
    {}

    std::vector<PageSlice> slices() const
    {
        std::vector<PageSlice> out;
        for (std::size_t first = 0; first < m_units.size();) {
            PageSlice slice{m_units[first].top, 0, headAbove(first)};
            double room = roomBelow(slice);
            while (m_units[first].bottom - slice.top > room + kRounding) { // higher than a page
                slice.bottom = slice.top + room;
                out.push_back(slice);
                slice.top = slice.bottom;
            }
            const std::size_t end = endOfPage(first, slice.top + room);
            slice.bottom = m_units[end - 1].bottom;
            out.push_back(slice);
            first = end;
        }
        return out;
    }

private:
    /// The table whose head is repeated above a row of its body that begins a page. A head of half a page is not.
    std::optional<std::size_t> headAbove(std::size_t unit) const
    {
        const auto table = m_units[unit].table;
        if (!table || m_units[unit].top + kRounding < m_tables[*table].headBottom || m_tables[*table].headHeight() <= 0
            || m_tables[*table].headHeight() > m_height / 2)
            return std::nullopt;
        return table;
    }

    double roomBelow(const PageSlice &slice) const { return m_height - (slice.head ? m_tables[*slice.head].headHeight() : 0); }

    /// The first unit of the next page.
    std::size_t endOfPage(std::size_t first, double bottom) const
    {
        std::size_t end = first + 1;
        while (end < m_units.size() && !m_units[end].beginsPage && m_units[end].bottom <= bottom + kRounding)
            ++end;
        if (end == m_units.size() || m_units[end].beginsPage)
            return end;
        for (std::size_t earlier = end; earlier > first; --earlier) {
            if (mayBegin(earlier))
                return earlier;
        }
        return end; // what belongs together is higher than a page
    }

    bool mayBegin(std::size_t unit) const
    {
        const PageUnit &before = m_units[unit - 1];
        if (before.keepsNext)
            return false;
        const auto table = m_units[unit].table;
        return !table || before.table != table || m_tables[*table].bottom - m_tables[*table].top > m_height / 2;
    }

    const std::vector<PageUnit> &m_units;
    const std::vector<TableExtent> &m_tables;
    const double m_height;
};

} // namespace

std::vector<PageSlice> paginate(const std::vector<PageUnit> &units, const std::vector<TableExtent> &tables, double height)
{
    return Paginator(units, tables, height).slices();
}

} // namespace skyseal::app
