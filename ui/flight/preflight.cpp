#include "ui/flight/preflight.h"

#include "core/engine/station/snapshot.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <algorithm>
#include <utility>

namespace skyseal::ui {

void Preflight::showViewState(const ViewState &view)
{
    m_station = view.station();
    for (auto list = m_lists.begin(); list != m_lists.end(); ++list) {
        const auto *state = stateOf(static_cast<std::uint8_t>(list.key()));
        if (state && std::exchange(list->armed, state->armed) && !state->armed && !list->ticked.isEmpty()) {
            list->ticked.clear();
            Q_EMIT changed();
        }
    }
}

const vehicle::VehicleState *Preflight::stateOf(std::uint8_t systemId) const
{
    if (!m_station)
        return nullptr;
    const auto at = std::ranges::find_if(m_station->vehicles, [&](const auto &one) { return one.state.systemId == systemId; });
    return at == m_station->vehicles.end() ? nullptr : &at->state;
}

void Preflight::setFiles(const Files &files)
{
    m_files = files;
    m_lists.clear();
    for (auto file = files.begin(); file != files.end(); ++file)
        read(file.value(), m_lists[file.key()]);
    Q_EMIT changed();
}

void Preflight::setFile(std::uint8_t systemId, const QString &path)
{
    m_files.remove(systemId);
    m_lists.remove(systemId);
    if (!path.isEmpty()) {
        m_files.insert(systemId, path);
        read(path, m_lists[systemId]);
    }
    Q_EMIT filesChanged();
    Q_EMIT changed();
}

void Preflight::reload(std::uint8_t systemId)
{
    if (const QString path = file(systemId); !path.isEmpty()) {
        read(path, m_lists[systemId]);
        Q_EMIT changed();
    }
}

void Preflight::read(const QString &path, List &list)
{
    list.items.clear();
    list.problems.clear();
    QFile in(path);
    if (!in.open(QIODevice::ReadOnly)) {
        list.problems << tr("%1 cannot be read: %2").arg(path, in.errorString());
        return;
    }
    const std::string text = in.read(static_cast<qint64>(vehicle::kMaxChecklistSize) + 1).toStdString();
    auto parsed = vehicle::parseChecklist(text, QFileInfo(path).fileName().toStdString());
    if (!parsed) {
        list.problems << reasonText(parsed.error().reason());
        return;
    }
    for (const InputError &problem : parsed->problems)
        list.problems << reasonText(problem.reason());
    list.items = std::move(parsed->items);
}

std::vector<Preflight::Item> Preflight::items(std::uint8_t systemId) const
{
    std::vector<Item> out;
    const auto list = m_lists.constFind(systemId);
    if (list == m_lists.constEnd())
        return out;
    const vehicle::VehicleState *state = stateOf(systemId);
    const bool current = state && state->messageAge <= state->staleAfter;
    for (const vehicle::ChecklistItem &item : list->items) {
        const QString text = fromStd(item.text);
        out.push_back({text, fromStd(item.conditionText),
                       item.condition ? current && item.condition->fulfilledBy(*state) : list->ticked.contains(text)});
    }
    return out;
}

void Preflight::tick(std::uint8_t systemId, const QString &text, bool done)
{
    const auto list = m_lists.find(systemId);
    if (list == m_lists.end() || list->ticked.contains(text) == done)
        return;
    if (done)
        list->ticked.insert(text);
    else
        list->ticked.remove(text);
    Q_EMIT changed();
}

QStringList Preflight::open(std::uint8_t systemId) const
{
    QStringList out;
    for (const Item &item : items(systemId))
        if (!item.done)
            out << item.text;
    if (const auto list = m_lists.constFind(systemId); list != m_lists.constEnd() && list->items.empty())
        out << tr("the checklist, which cannot be read");
    return out;
}

} // namespace skyseal::ui

#include "moc_preflight.cpp"
