#include "core/experiment/html_parts.h"

#include "core/experiment/bar_chart.h"

namespace skyseal::experiment {

namespace {

std::string rowOf(const std::vector<std::string> &cells, const char *tag)
{
    std::string out = "<tr>";
    for (const std::string &cell : cells)
        out += std::string("<") + tag + ">" + cell + "</" + tag + ">";
    return out + "</tr>\n";
}

} // namespace

std::string row(const std::vector<std::string> &cells)
{
    return rowOf(cells, "td");
}

std::string headOfTable(const std::vector<std::vector<std::string>> &rows)
{
    std::string out = "<thead>\n";
    for (const std::vector<std::string> &cells : rows)
        out += rowOf(cells, "th");
    return out + "</thead>\n";
}

std::string figuresInPairs(const std::vector<ReportFigure> &figures)
{
    std::string out;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        out += i % 2 == 0 ? "<table><tr><td>" : "<td>";
        out += "<img src=\"figures/" + figures[i].name + ".svg\"/></td>";
        out += i % 2 == 1 || i + 1 == figures.size() ? "</tr></table>\n" : "";
    }
    return out;
}

std::string armText(const SweepArm &arm)
{
    return isInsecure(arm) ? "<span class=\"insecure\">" + escaped(name(arm)) + " (insecure)</span>" : escaped(name(arm));
}

} // namespace skyseal::experiment
