// Texts that their control has no room for: the choice in a box, the heads of a list, the hint in an empty line.
#pragma once

#include <QtWidgets/QAbstractScrollArea>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QStyle>
#include <QtWidgets/QStyleOption>

namespace skyseal::ui {

inline bool isChoiceCut(const QComboBox &box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.subControls = QStyle::SC_All;
    option.frame = box.hasFrame();
    int room = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width() - 2;
    if (!box.itemIcon(box.currentIndex()).isNull())
        room -= box.iconSize().width() + 4;
    return box.fontMetrics().horizontalAdvance(box.currentText()) > room;
}

inline bool isHintCut(const QLineEdit &line)
{
    QStyleOptionFrame option;
    option.initFrom(&line);
    option.lineWidth = line.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &line);
    constexpr int kMargins = 4; // of a QLineEdit
    const int room = line.style()->subElementRect(QStyle::SE_LineEditContents, &option, &line).width() - kMargins;
    return line.text().isEmpty() && line.fontMetrics().horizontalAdvance(line.placeholderText()) > room;
}

/// The text that a visible control cuts; empty if all of it is seen.
inline QString cutTextOf(const QWidget &widget)
{
    if (const auto *box = qobject_cast<const QComboBox *>(&widget); box && !box->isEditable())
        return isChoiceCut(*box) ? box->currentText() : QString();
    if (const auto *line = qobject_cast<const QLineEdit *>(&widget))
        return isHintCut(*line) ? line->placeholderText() : QString();
    const auto *header = qobject_cast<const QHeaderView *>(&widget);
    if (!header || header->orientation() != Qt::Horizontal || !header->model())
        return {};
    for (int i = 0; i < header->count(); ++i)
        if (!header->isSectionHidden(i) && header->sectionSizeHint(i) > header->sectionSize(i))
            return header->model()->headerData(i, Qt::Horizontal).toString();
    return {};
}

} // namespace skyseal::ui
