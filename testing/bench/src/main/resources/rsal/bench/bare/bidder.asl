// Bids for whatever somebody calls for, and has done it at once.

+cfp(Id, _)[source(Manager)]
   <- .abolish(cfp(Id, _));
      .random(Cost);
      .send(Manager, tell, propose(Id, Cost)).

+accept_proposal(Id)[source(Manager)]
   <- .abolish(accept_proposal(Id));
      .send(Manager, tell, done(Id)).

+reject_proposal(Id)
   <- .abolish(reject_proposal(Id)).
