#include "ui/replay/timeline_access.h"

#include "ui/replay/replay_timeline.h"
#include "ui/text/units.h"

#include <QtWidgets/QAccessibleWidget>

namespace skyseal::ui {

namespace {

class TimelineAccess : public QAccessibleWidget, public QAccessibleValueInterface
{
public:
    explicit TimelineAccess(ReplayTimeline &line) : QAccessibleWidget(&line, QAccessible::Slider), m_line(line) {}

    void *interface_cast(QAccessible::InterfaceType type) override
    {
        return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface *>(this)
                                                   : QAccessibleWidget::interface_cast(type);
    }
    QString text(QAccessible::Text kind) const override
    {
        const auto at = [](int milliseconds) { return durationText(milliseconds / 1000.0); };
        return kind == QAccessible::Value ? ReplayTimeline::tr("%1 of %2").arg(at(m_line.value()), at(m_line.maximum()))
                                          : QAccessibleWidget::text(kind);
    }

    QVariant currentValue() const override { return m_line.value(); }
    void setCurrentValue(const QVariant &value) override { m_line.seekTo(value.toInt()); }
    QVariant maximumValue() const override { return m_line.maximum(); }
    QVariant minimumValue() const override { return m_line.minimum(); }
    QVariant minimumStepSize() const override { return m_line.singleStep(); }

private:
    ReplayTimeline &m_line;
};

} // namespace

void installTimelineAccess()
{
    static const bool installed = [] {
        QAccessible::installFactory([](const QString &, QObject *object) -> QAccessibleInterface * {
            auto *line = qobject_cast<ReplayTimeline *>(object);
            return line ? new TimelineAccess(*line) : nullptr;
        });
        return true;
    }();
    static_cast<void>(installed);
}

} // namespace skyseal::ui
