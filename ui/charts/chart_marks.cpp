// Marks of events on the time line. They are derived from the samples, so that a mark stands exactly where the lines change.
#include "ui/charts/chart_builder.h"

#include "ui/text/units.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

using engine::MetricsSample;

namespace {

/// The translation context of the functions below.
struct ChartMarksText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ChartMarks)
};

/// Refused records within this time in seconds are one incident.
constexpr double kOneIncident = 5;

class MarkMaker
{
public:
    MarkMaker(double zero, const QColor &alarm, const QColor &dim) : m_zero(zero), m_alarm(alarm), m_dim(dim) {}

    void follow(const MetricsSample &before, const MetricsSample &sample)
    {
        if (sample.refused > before.refused)
            refuse(sample, sample.refused - before.refused);
        if (sample.linkUp != before.linkUp) {
            if (m_heard)
                add(sample, m_dim, sample.linkUp ? ChartMarksText::tr("link recovered") : ChartMarksText::tr("link lost"),
                    true);
        }
    }

    /// For two samples with a link, and any number of samples without one between them.
    void change(const MetricsSample &before, const MetricsSample &sample)
    {
        if (before.suite != sample.suite)
            add(sample, suiteColor(sample.suite), suiteName(sample.suite), false);
        else if (before.epoch != sample.epoch)
            add(sample, m_dim, ChartMarksText::tr("new keys, epoch %1").arg(sample.epoch), false);
    }

    void heard() { m_heard = true; }
    std::vector<ChartMark> take() { return std::move(m_marks); }

private:
    void add(const MetricsSample &sample, const QColor &color, const QString &text, bool incident)
    {
        m_marks.push_back({sample.time - m_zero, color, text, incident});
    }

    void refuse(const MetricsSample &sample, std::uint64_t count)
    {
        if (m_attack < 0 || sample.time - m_attackSeen > kOneIncident) {
            m_attack = static_cast<std::ptrdiff_t>(m_marks.size());
            m_refused = 0;
            add(sample, m_alarm, {}, true);
        }
        m_attackSeen = sample.time;
        m_refused += count;
        m_marks[static_cast<std::size_t>(m_attack)].text =
            ChartMarksText::tr("%1 forged, replayed or plain, refused").arg(grouped(m_refused));
    }

    double m_zero;
    QColor m_alarm, m_dim;
    std::vector<ChartMark> m_marks;
    bool m_heard = false;
    std::ptrdiff_t m_attack = -1;
    double m_attackSeen = 0;
    std::uint64_t m_refused = 0;
};

} // namespace

std::vector<ChartMark> buildMarks(const SampleHistory &history, const ChartRange &range, const QColor &alarm, const QColor &dim)
{
    const double zero = range.zero(history.newest());
    MarkMaker maker(zero, alarm, dim);
    const MetricsSample *before = nullptr, *linked = nullptr;
    for (const MetricsSample &sample : history.samples()) {
        if (before)
            maker.follow(*before, sample);
        if (sample.linkUp) {
            maker.heard();
            if (linked)
                maker.change(*linked, sample);
            linked = &sample;
        }
        before = &sample;
    }
    std::vector<ChartMark> marks = maker.take();
    std::erase_if(marks, [&](const ChartMark &mark) { return mark.x < range.from() || mark.x > range.to(); });
    return marks;
}

} // namespace skyseal::ui
