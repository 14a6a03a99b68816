// The messages panel: texts of the vehicles (STATUSTEXT), events of the links and results of commands, with filter and copy.
#pragma once

#include "core/engine/common/peer_names.h"
#include "ui/messages/message_filter.h"
#include "ui/messages/message_model.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QTreeView;

namespace skyseal::engine {
struct EventText;
}

namespace skyseal::ui {

class MessagesPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit MessagesPanel(QWidget *parent = nullptr);

    /// Appends the text of an event, unless the event is routine. Call for every event, in order.
    void handleEvent(const engine::Event &event);
    /// Appends the text of an event of the recording that is replayed.
    void handleReplayEvent(const engine::Event &event);
    /// Adds a line with the result of a command; `ok` is false if the vehicle refused it or did not answer.
    void showCommandResult(const QString &line, bool ok);
    MessageModel &model() { return m_model; }

private:
    static QString withRemedy(const engine::EventText &text, const QString &words);
    std::uint64_t append(const Message &message);
    bool countRefusal(const engine::Event &event);
    void copySelected() const;

    /// One line for all refusals of a kind, which counts while they go on.
    struct RefusalLine
    {
        std::uint64_t number = 0; ///< of the message
        std::uint64_t frames = 0;
        QDateTime last;
    };

    engine::PeerNames m_peers;
    QHash<QString, RefusalLine> m_refusals; ///< by kind, vehicle and peer
    MessageModel m_model;
    MessageFilter m_filter;
    QTreeView *m_view;
    bool m_followsNewest = true; ///< unless the operator scrolls up
};

} // namespace skyseal::ui
