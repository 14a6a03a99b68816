// The console: what the vehicles say (STATUSTEXT) and what happened on the links, with filter and copy.
#pragma once

#include "ui/messages/message_filter.h"
#include "ui/messages/message_model.h"
#include "ui/view_state.h"

#include <QtWidgets/QWidget>

class QTreeView;

namespace skyseal::ui {

class MessagesPanel : public QWidget
{
    Q_OBJECT

public:
    explicit MessagesPanel(QWidget *parent = nullptr);

    void take(const engine::Event &event);
    /// A line of the station's own.
    void say(const QString &text, std::uint8_t severity);
    MessageModel &model() { return m_model; }

private:
    void append(const Message &message);
    void copySelected() const;

    MessageModel m_model;
    MessageFilter m_filter;
    QTreeView *m_view;
};

} // namespace skyseal::ui
