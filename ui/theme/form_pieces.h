// What the dialogs with many fields are put together from.
#pragma once

#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Names a widget for tests and for screen readers; gives it back.
template<typename W> W *named(W *widget, const char *objectName, const QString &accessible)
{
    widget->setObjectName(QLatin1String(objectName));
    widget->setAccessibleName(accessible);
    return widget;
}

/// An explanation under what it explains.
inline QLabel *smallPrint(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

} // namespace skyseal::ui
