#include "ui/replay/link_event_text.h"

#include "core/engine/text/qt_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::LinkEventText)
};

} // namespace

QString unreadableEventsText(const tlog::LogIndex &index)
{
    if (index.unreadableEvents == 0)
        return {};
    return engine::counted(index.unreadableEvents, Text::tr("one unreadable line about ciphers"),
                           Text::tr("%1 unreadable lines about ciphers"));
}

} // namespace skyseal::ui
