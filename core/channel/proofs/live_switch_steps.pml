/* The rules of section 8 as steps of one end, for live_switch.pml, which has the state. Spin replaces the parameters of inlines
   in the whole text, so that no two inlines may use the same name for one. */

#define sameSession (side[STATION].session == side[AGENT].session && side[STATION].key && side[AGENT].key)
#define reads(y, seal) ((seal) && (side[y].key == (seal) || side[y].previous == (seal) || side[y].next == (seal)))
#define underway(y) (probe == FLYING && probeOf != (y) && probeSeal == side[y].previous)
#define missing(y) ((probe == FLYING || probe == LOST) && probeOf != (y) && probeSeal == side[y].previous)
#ifdef NO_SPARING
#define dispensable(y) true
#else
#define dispensable(y) \
    (!side[y].previous || (side[y].countKnown && !missing(y)) || (side[y].peerMoved && !underway(y)))
#endif
#ifdef NO_SETTLING
#define ready(y) dispensable(y)
#else
#define ready(y) (side[y].settled && dispensable(y))
#endif
#define peersTurn(x) (side[x].theirs == ACCEPTED)
#ifdef TRIED_ONCE
#define rekeyDue(x) (side[x].sent >= SOFT_LIMIT && !side[x].own && !peersTurn(x) && !side[x].tried)
#else
#define rekeyDue(x) (side[x].sent >= SOFT_LIMIT && !side[x].own && !peersTurn(x))
#endif

/* ---- steps of the protocol */

inline giveUp(giver)
{
    side[giver].failed = side[giver].failed | bit(side[giver].made);
    side[giver].own = NOTHING;
}

inline wish(wisher)
{
    if
    :: side[wisher].own -> giveUp(wisher)
    :: else
    fi;
    side[wisher].made++;
    side[wisher].own = QUEUED;
}

inline propose(offerer)
{
    side[offerer].own = PROPOSED;
    side[offerer].proposes = side[offerer].proposes | bit(side[offerer].made);
    side[offerer].proposeSeal[side[offerer].made] = side[offerer].key;
    side[offerer].proposeEpoch[side[offerer].made] = side[offerer].epoch + 1;
}

/* The prepared epoch becomes the current one, for sending, too. */
inline commit(mover)
{
    side[mover].previous = side[mover].key;
    side[mover].key = side[mover].next;
    side[mover].next = 0;
#ifdef WIPE_AT_ONCE
    side[mover].previous = 0;
#endif
    side[mover].epoch++;
    side[mover].peerMoved = false;
    side[mover].countKnown = false;
    side[mover].settled = false;
#ifdef REKEY
    side[mover].sent = 0;
    side[mover].tried = false;
#endif
    check(FRESH, !(side[mover].begun & bit(side[mover].key)));
    side[mover].begun = side[mover].begun | bit(side[mover].key)
}

/* An authentic record sealed under `seal` has arrived at y. */
inline opened(reader, under)
{
    if
    :: side[reader].next == (under) && side[reader].theirs ->
        check(DECISION, !(side[1 - (reader)].failed & bit(side[reader].newest)));
        side[reader].theirs = NOTHING;
        commit(reader);
        if
        :: side[reader].own == PROPOSED -> giveUp(reader)
        :: else
        fi
    :: else
    fi;
    if
    :: side[reader].key == (under) -> side[reader].peerMoved = true
    :: else
    fi
}

inline accept(acceptor, acceptedId)
{
    side[acceptor].theirs = ACCEPTED;
    side[acceptor].next = KEY(1 - (acceptor), acceptedId, 0);
    side[acceptor].accepts = side[acceptor].accepts | bit(acceptedId);
    side[acceptor].answerSeal[acceptedId] = side[acceptor].key;
#ifdef EARLY_ANSWERER
    side[acceptor].theirs = NOTHING;
    commit(acceptor)
#endif
}

inline makeWay(yielder)
{
    if
#ifdef ANSWER_BOTH
    :: side[yielder].own == PROPOSED && yielder == AGENT -> giveUp(yielder)
#else
    :: side[yielder].own == PROPOSED -> giveUp(yielder)
#endif
    :: else
    fi
}

/* The proposal of the peer arrives at y; `allowed` by the settings of y. */
inline handlePropose(asked, askedId, permitted)
{
    opened(asked, side[1 - (asked)].proposeSeal[askedId]);
    if
    :: side[1 - (asked)].proposeEpoch[askedId] != side[asked].epoch + 1
#ifndef OLD_PROPOSALS
    :: askedId < side[asked].newest
#endif
    :: askedId == side[asked].newest && side[1 - (asked)].proposeEpoch[askedId] == side[asked].epoch + 1 ->
#ifdef FRESH_ANSWERS
        if
        :: side[asked].theirs ->
            side[asked].next = KEY(1 - (asked), askedId, 1);
            side[asked].secondAccepts = side[asked].secondAccepts | bit(askedId)
        :: else
        fi
#else
        skip /* the same answer again */
#endif
#ifdef OLD_PROPOSALS
    :: askedId != side[asked].newest && side[1 - (asked)].proposeEpoch[askedId] == side[asked].epoch + 1 ->
#else
    :: askedId > side[asked].newest && side[1 - (asked)].proposeEpoch[askedId] == side[asked].epoch + 1 ->
#endif
        if
#if !defined(NO_WINNER) && !defined(ANSWER_BOTH)
        :: side[asked].own == PROPOSED && asked == STATION
#endif
        :: permitted && !ready(asked)
        :: else ->
            side[asked].newest = askedId;
            makeWay(asked);
            side[asked].theirs = NOTHING;
            side[asked].next = 0;
            if
            :: permitted -> accept(asked, askedId)
            :: else ->
                side[asked].refuses = side[asked].refuses | bit(askedId);
                side[asked].answerSeal[askedId] = side[asked].key
            fi
        fi
    fi
}

#ifdef LATE_ACCEPT
#define takesAccept(x, proposalId) (side[x].made == proposalId && (side[x].own == PROPOSED || side[x].failed & bit(proposalId)))
#else
#ifdef ANY_ID
#define takesAccept(x, proposalId) (side[x].own == PROPOSED)
#else
#define takesAccept(x, proposalId) (side[x].own == PROPOSED && side[x].made == proposalId)
#endif
#endif

inline handleAccept(owner, answeredId, variant)
{
    opened(owner, side[1 - (owner)].answerSeal[answeredId]);
    if
    :: takesAccept(owner, answeredId) ->
        check(DECISION, !(side[owner].failed & bit(answeredId)));
        side[owner].theirs = NOTHING;
        side[owner].next = (side[owner].made == answeredId -> KEY(owner, answeredId, variant) : MIXED_KEY);
        commit(owner);
        side[owner].confirming = true;
        side[owner].own = NOTHING
    :: else
    fi
}

inline handleRefuse(loser, lostId)
{
    opened(loser, side[1 - (loser)].answerSeal[lostId]);
    if
    :: side[loser].own == PROPOSED && side[loser].made == lostId -> giveUp(loser)
    :: else
    fi
}

inline handleConfirm(follower, followed)
{
    opened(follower, followed);
    if
    :: side[follower].key == (followed) && !side[follower].confirming ->
        if
        :: !side[follower].settled -> side[follower].countKnown = true
        :: else
        fi;
        side[follower].settled = true;
        side[follower].confirmeds = side[follower].confirmeds | bit(followed)
    :: else
    fi
}

inline handleConfirmed(leader, led)
{
    opened(leader, led);
    if
    :: side[leader].confirming && side[leader].key == (led) ->
        side[leader].countKnown = true;
        side[leader].confirming = false;
        side[leader].settled = true
    :: else
    fi
}

inline handleProbe()
{
    if
    :: sameSession ->
        check(ARRIVAL, reads(1 - probeOf, probeSeal));
        if
        :: reads(1 - probeOf, probeSeal) -> opened(1 - probeOf, probeSeal)
        :: else
        fi
    :: else
    fi;
    probe = ARRIVED
}
