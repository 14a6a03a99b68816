#include "ui/mission/mission_file.h"

#include <QtCore/QString>
#include <QtCore/QStringList>

#include <cmath>

namespace skyseal::ui {

namespace {

constexpr qsizetype kColumns = 12;

struct Numbers
{
    double at[kColumns]{};
    bool ok = true;
};

Numbers numbersOf(const QStringList &cells)
{
    Numbers out;
    for (qsizetype i = 0; i < kColumns && out.ok; ++i) {
        out.at[i] = cells[i].toDouble(&out.ok);
        out.ok = out.ok && std::isfinite(out.at[i]);
    }
    return out;
}

} // namespace

Result<std::vector<vehicle::MissionItem>, InputError> parseMission(std::string_view text, const std::string &source)
{
    const QStringList lines = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).split(QLatin1Char('\n'));
    if (lines.first().trimmed() != QLatin1String("QGC WPL 110"))
        return tl::unexpected(InputError{"no mission file: the first line must be \"QGC WPL 110\"", source, 1});
    std::vector<vehicle::MissionItem> items;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QString line = lines[i].simplified();
        if (line.isEmpty())
            continue;
        const auto at = static_cast<std::size_t>(i + 1);
        const QStringList cells = line.split(QLatin1Char(' '));
        if (cells.size() != kColumns)
            return tl::unexpected(
                InputError{"an item has 12 columns, this line has " + std::to_string(cells.size()), source, at});
        const Numbers n = numbersOf(cells);
        const bool inRange = n.ok && n.at[0] == static_cast<double>(items.size()) && n.at[2] >= 0 && n.at[2] <= 255
            && n.at[3] >= 0 && n.at[3] <= 65535 && std::abs(n.at[8]) <= 90 && std::abs(n.at[9]) <= 180;
        if (!inRange)
            return tl::unexpected(
                InputError{"a column is not a number or is out of range, or the numbering has a gap", source, at});
        vehicle::MissionItem item;
        item.sequence = static_cast<std::uint16_t>(n.at[0]);
        item.current = n.at[1] != 0;
        item.frame = static_cast<std::uint8_t>(n.at[2]);
        item.command = static_cast<std::uint16_t>(n.at[3]);
        for (int p = 0; p < 4; ++p)
            item.parameters[p] = static_cast<float>(n.at[4 + p]);
        item.latitude = n.at[8];
        item.longitude = n.at[9];
        item.altitude = static_cast<float>(n.at[10]);
        item.autoContinue = n.at[11] != 0;
        items.push_back(item);
    }
    if (items.empty())
        return tl::unexpected(InputError{"the mission has no items", source});
    return items;
}

std::string missionText(const std::vector<vehicle::MissionItem> &items)
{
    QString out = QStringLiteral("QGC WPL 110\n");
    for (const vehicle::MissionItem &item : items) {
        QStringList cells{QString::number(item.sequence), QString::number(int(item.current)), QString::number(item.frame),
                          QString::number(item.command)};
        for (const float parameter : item.parameters)
            cells << QString::number(static_cast<double>(parameter), 'g', 9);
        cells << QString::number(item.latitude, 'f', 8) << QString::number(item.longitude, 'f', 8)
              << QString::number(static_cast<double>(item.altitude), 'f', 3) << QString::number(int(item.autoContinue));
        out += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return out.toStdString();
}

} // namespace skyseal::ui
