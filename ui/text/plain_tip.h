// A tool tip that shows a text as it is. Qt takes one that looks like HTML for HTML, and what vehicles say must be no markup.
#pragma once

#include <QtCore/QString>

namespace skyseal::ui {

inline QString plainTip(const QString &text)
{
    return text.isEmpty() ? QString() : QStringLiteral("<span>%1</span>").arg(text.toHtmlEscaped());
}

} // namespace skyseal::ui
