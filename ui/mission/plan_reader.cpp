#include "ui/mission/plan_reader.h"

#include "core/engine/text/event_text.h"
#include "core/mavlink/enums.h"

namespace skyseal::ui {

using vehicle::MissionType;

namespace {

struct PlanReaderText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::PlanReader)
};

QString readingText(MissionType type)
{
    switch (type) {
    case MissionType::Fence: return PlanReaderText::tr("Reading the fence…");
    case MissionType::Rally: return PlanReaderText::tr("Reading the rally points…");
    case MissionType::Mission: break;
    }
    return PlanReaderText::tr("Reading the mission…");
}

QString countText(MissionType type, std::size_t items)
{
    switch (type) {
    case MissionType::Fence: return PlanReaderText::tr("fence: %1").arg(items);
    case MissionType::Rally: return PlanReaderText::tr("rally points: %1").arg(items);
    case MissionType::Mission: break;
    }
    return PlanReaderText::tr("mission items: %1").arg(items);
}

} // namespace

void PlanReader::read(std::uint8_t systemId, std::uint64_t capabilities)
{
    if (isReading())
        return;
    m_systemId = systemId;
    m_read.clear();
    m_failures.clear();
    m_pending = {MissionType::Mission};
    if (capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_FENCE)
        m_pending.push_back(MissionType::Fence);
    if (capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_RALLY)
        m_pending.push_back(MissionType::Rally);
    requestNext();
}

void PlanReader::requestNext()
{
    m_text = readingText(m_pending.front());
    m_request = m_station.perform(m_systemId, vehicle::ReadMission{m_pending.front()});
}

bool PlanReader::handleResult(const vehicle::MissionResult &result)
{
    if (!isReading() || result.systemId != m_systemId || result.id != m_request)
        return false;
    m_pending.pop_front();
    if (result.ok)
        m_read << countText(result.type, result.items ? result.items->size() : 0);
    else
        m_failures << engine::eventText(result, {}).sentence;
    if (!result.ok && result.type == MissionType::Mission)
        m_pending.clear();
    if (isReading()) {
        requestNext();
        return true;
    }
    m_text = m_failures.join(QStringLiteral(". "));
    if (!m_read.isEmpty()) {
        const QString read = tr("Read: %1").arg(m_read.join(QStringLiteral(", ")));
        m_text = m_text.isEmpty() ? read : m_text + QStringLiteral(". ") + read;
    }
    return true;
}

} // namespace skyseal::ui
