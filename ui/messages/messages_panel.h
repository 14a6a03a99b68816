// Panel with the messages of the vehicles (STATUSTEXT) and the events of the station, with filter and copy. Main thread.
#pragma once

#include "core/engine/common/peer_names.h"
#include "ui/messages/message_filter.h"
#include "ui/messages/message_model.h"
#include "ui/view_state.h"

#include <QtWidgets/QWidget>

class QTreeView;

namespace skyseal::engine {
struct EventText;
}

namespace skyseal::ui {

class MessagesPanel : public QWidget
{
    Q_OBJECT

public:
    explicit MessagesPanel(QWidget *parent = nullptr);

    /// Appends the sentence for an event, unless the event is routine. Call for every event, in order.
    void take(const engine::Event &event);
    /// Appends a line of the station itself; `severity` is MAV_SEVERITY.
    void say(const QString &text, std::uint8_t severity);
    MessageModel &model() { return m_model; }

private:
    static QString withRemedy(const engine::EventText &text);
    void append(const Message &message);
    void copySelected() const;

    engine::PeerNames m_peers;
    MessageModel m_model;
    MessageFilter m_filter;
    QTreeView *m_view;
};

} // namespace skyseal::ui
