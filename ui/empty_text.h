// Says in an empty list what will be there.
#pragma once

#include <QtCore/QEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Lies over `view` while `model`, whose rows it shows perhaps filtered, has none. Belongs to the view.
class EmptyText : public QLabel
{
public:
    EmptyText(QAbstractItemView &view, const QAbstractItemModel &model, const QString &text, const char *objectName)
        : QLabel(text, &view), m_view(view), m_model(model)
    {
        setObjectName(QLatin1String(objectName));
        setWordWrap(true);
        setAlignment(Qt::AlignCenter);
        setForegroundRole(QPalette::PlaceholderText);
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
        view.viewport()->installEventFilter(this);
        const auto follow = [this] { setVisible(m_model.rowCount() == 0); };
        connect(&model, &QAbstractItemModel::modelReset, this, follow);
        connect(&model, &QAbstractItemModel::rowsInserted, this, follow);
        connect(&model, &QAbstractItemModel::rowsRemoved, this, follow);
        follow();
    }

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
            setGeometry(m_view.viewport()->geometry());
        return false;
    }

private:
    QAbstractItemView &m_view;
    const QAbstractItemModel &m_model;
};

} // namespace skyseal::ui
