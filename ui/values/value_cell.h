// One cell of the grid of values: caption, value and unit, the word of a limit that is passed or the age of an old value, and a
// line of the last minute if it is chosen. A label, so that assistive technology reads its text.
#pragma once

#include "ui/value_choice.h"
#include "ui/sparkline.h"
#include "ui/values/value_reading.h"

#include <QtWidgets/QLabel>

namespace skyseal::ui {

class ValueCell : public QLabel
{
    Q_OBJECT

public:
    ValueCell(const ValueChoice &choice, QWidget *parent);

    const ValueChoice &choice() const { return m_choice; }
    /// Repaints only if something that is seen has changed.
    void showReading(const ValueReading &reading, UnitSystem units);
    /// Another sample for the line, `time` in seconds of the picture.
    void addSample(double time, const ValueReading &reading);
    void clearLine();
    /// Greatest size of the digits in pixels, of which a text that is too wide takes less, and the height below them that is
    /// kept for a line.
    void setRoom(int digits, int line);

    QString value() const { return m_value; }
    QString unit() const { return m_unit; }
    /// "▲ high", "▼ low", what qualifies the value, or the age of an old one; else empty.
    QString note() const { return m_note; }
    bool isStale() const { return m_stale; }

    int captionHeight() const;
    static constexpr int kLineHeight = 16; ///< pixels
    QSize sizeHint() const override { return minimumSizeHint(); }
    /// Without the room of a line, which is the same in a whole row.
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QFont captionFont() const;

    ValueChoice m_choice;
    ValueUnit m_shown;
    QString m_value, m_unit, m_note;
    bool m_stale = false, m_bad = false;
    int m_digits = 0, m_lineRoom = 0;
    Sparkline m_line;
};

} // namespace skyseal::ui
