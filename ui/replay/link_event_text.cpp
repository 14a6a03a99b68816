#include "ui/replay/link_event_text.h"

#include "core/engine/text/qt_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct LinkEventText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::LinkEventText)
};

} // namespace

QString unreadableEventsText(const tlog::LogIndex &index)
{
    if (index.unreadableEvents == 0)
        return {};
    return engine::counted(index.unreadableEvents, LinkEventText::tr("one unreadable line about ciphers"),
                           LinkEventText::tr("%1 unreadable lines about ciphers"));
}

} // namespace skyseal::ui
