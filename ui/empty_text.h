// Says in an empty list what will be there, or that its filter hides everything.
#pragma once

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Lies over `view` while it shows no row. `model` has the rows that may be shown; the view may have a filter of it as its
/// model, which must be set before. Belongs to the view.
class EmptyText : public QLabel
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::EmptyText)

public:
    EmptyText(QAbstractItemView &view, const QAbstractItemModel &model, const QString &text, const char *objectName)
        : QLabel(text, &view), m_view(view), m_model(model), m_text(text)
    {
        setObjectName(QLatin1String(objectName));
        setWordWrap(true);
        setAlignment(Qt::AlignCenter);
        setForegroundRole(QPalette::PlaceholderText);
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
        view.viewport()->installEventFilter(this);
        follow(model);
        if (view.model() != &model)
            follow(*view.model());
        refresh();
    }

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
            setGeometry(m_view.viewport()->geometry());
        return false;
    }

private:
    void follow(const QAbstractItemModel &model)
    {
        connect(&model, &QAbstractItemModel::modelReset, this, [this] { refresh(); });
        connect(&model, &QAbstractItemModel::rowsInserted, this, [this] { refresh(); });
        connect(&model, &QAbstractItemModel::rowsRemoved, this, [this] { refresh(); });
    }

    void refresh()
    {
        const QString now = m_model.rowCount() == 0 ? m_text : tr("Nothing matches the filter.");
        if (text() != now)
            setText(now);
        setVisible(m_view.model()->rowCount() == 0);
    }

    QAbstractItemView &m_view;
    const QAbstractItemModel &m_model;
    const QString m_text;
};

} // namespace skyseal::ui
