// One word group of the status strip: an icon and a text that exists in several lengths.
#pragma once

#include <QtCore/QStringList>
#include <QtGui/QColor>
#include <QtWidgets/QAbstractButton>

namespace skyseal::ui {

class StripItem : public QAbstractButton
{
    Q_OBJECT

public:
    explicit StripItem(const QString &accessibleName, QWidget *parent = nullptr);

    /// Texts for the same thing, the longest first. Repaints and asks for a new layout only when something changed.
    void setContent(const QStringList &variants, const QString &iconName = {});
    /// Texts as wide as they may get, one for each variant, so that changing figures keep their room.
    void setSamples(const QStringList &samples);
    /// Colour of the icon; invalid = as the text.
    void setIconColor(const QColor &color);
    void setTextColor(const QColor &color);
    void setStrong(bool strong);
    /// Items that do something when clicked take the keyboard's focus.
    void setClickable(bool clickable);

    int variantCount() const { return static_cast<int>(m_variants.size()); }
    int widthOf(int variant) const;
    void setVariant(int variant);
    int variant() const { return m_variant; }

    QSize sizeHint() const override;

Q_SIGNALS:
    void widthChanged();

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QFont textFont() const;

    QStringList m_variants, m_samples;
    QString m_icon;
    QColor m_iconColor, m_textColor;
    int m_variant = 0;
    bool m_strong = false, m_clickable = false;
};

} // namespace skyseal::ui
