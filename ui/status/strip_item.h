// One item of the status strip: an icon, a line of the last minute if it has one, and a text in several lengths.
#pragma once

#include "ui/sparkline.h"

#include <QtCore/QStringList>
#include <QtGui/QColor>
#include <QtWidgets/QAbstractButton>

#include <vector>

namespace skyseal::ui {

/// Texts with their widths in pixels. A width is measured when it is first needed: shaping a text costs more than all
/// else that the strip does with a snapshot.
class TextWidths
{
public:
    /// Returns whether they differ from those before.
    bool setTexts(const QStringList &texts);
    const QStringList &texts() const { return m_texts; }
    /// 0 for a text that does not exist.
    qreal widthOf(int index, const QFont &font) const;
    /// Measures anew, with another font.
    void forget();

private:
    QStringList m_texts;
    mutable std::vector<qreal> m_widths; ///< negative: not measured
};

class StripItem : public QAbstractButton
{
    Q_OBJECT

public:
    explicit StripItem(const QString &accessibleName, QWidget *parent = nullptr);

    /// Sets the same text in several lengths, longest first. Repaints and requests a layout only if something changed.
    void setContent(const QStringList &variants, const QString &iconName = {});
    /// Sets the widest expected text of each variant, so that changing numbers do not move the layout.
    void setSamples(const QStringList &samples);
    /// Sets the colour of the icon; invalid: the colour of the text.
    void setIconColor(const QColor &color);
    void setTextColor(const QColor &color);
    void setStrong(bool strong);
    /// Clickable items accept the keyboard focus.
    void setClickable(bool clickable);

    /// Keeps room for a line of the last minute, except in the shortest variant.
    void setLine(bool on);
    /// The next value of the line, from 0 to 100; NaN where there is none. `time` in seconds of the picture.
    void addSample(double time, double percent);
    const Sparkline &line() const { return m_line; }
    void clearLine();

    int variantCount() const { return static_cast<int>(m_variants.texts().size()); }
    int widthOf(int variant) const;
    void setVariant(int variant);
    int variant() const { return m_variant; }

    QSize sizeHint() const override;

Q_SIGNALS:
    void widthChanged();

protected:
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *) override;

private:
    QFont textFont() const;
    int lineRoom(int variant) const;
    void forgetWidths();

    TextWidths m_variants, m_samples;
    QString m_icon;
    QColor m_iconColor, m_textColor;
    int m_variant = 0;
    bool m_strong = false, m_clickable = false, m_hasLine = false;
    Sparkline m_line;
};

} // namespace skyseal::ui
