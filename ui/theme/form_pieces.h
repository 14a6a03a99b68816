// Helpers that dialogs with many fields use.
#pragma once

#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Sets object name and accessible name, and returns the widget.
template<typename W> W *named(W *widget, const char *objectName, const QString &accessible)
{
    widget->setObjectName(QLatin1String(objectName));
    widget->setAccessibleName(accessible);
    return widget;
}

/// An explanation below a field.
inline QLabel *smallPrint(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

} // namespace skyseal::ui
