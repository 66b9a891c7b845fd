// Collector: bids for things that others have found, fetches them with its gripper, and brings them to where it began.

period(0.5).  // How often it says where it is [s].

distance(X, Y, D) :- pose(MyX, MyY, _) & D = math.sqrt((X - MyX) ** 2 + (Y - MyY) ** 2).
in_map(X, Y, MapX, MapY) :- pose(MyX, MyY, Th)
   & MapX = MyX + X * math.cos(Th) - Y * math.sin(Th)
   & MapY = MyY + X * math.sin(Th) + Y * math.cos(Th).
// The thing that it aims at: the patch of its color that is where it should be.
sees(Color, TargetX, TargetY, X, Y) :- blob(Color, X, Y) & in_map(X, Y, MapX, MapY)
   & math.sqrt((TargetX - MapX) ** 2 + (TargetY - MapY) ** 2) < 1.

!settle.
!report.

+!settle
   <- .wait(2000); // until its localizer has settled
      .wait(pose(_, _, _));
      ?pose(X, Y, _);
      +home(X, Y);
      .df_register(collect);
      state("waiting for something to fetch").

+!report : period(Seconds)
   <- !say_where;
      .wait(Seconds * 1000);
      !!report.
+!say_where : pose(X, Y, Th) & robot(Me, Role)
   <- publish(pose, Me, Role, pose(X, Y, Th));
      !say_depot.
+!say_where.
+!say_depot : home(X, Y) & robot(Me, _)
   <- publish(depot, Me, point(X, Y), 1.5).
+!say_depot.

// The contract net. It bids the ways to the thing and home, while it has nothing else to do; nothing for what it is at
// already: whoever calls has not heard of it.
+!call(Id, _, _, _)[source(Master)] : job(Id, doing)
   <- .send(Master, tell, bid(Id, 0)).
+!call(Id, _, _, _)[source(Master)] : job(Id, done)
   <- .send(Master, tell, fetched(Id)).
+!call(Id, _, X, Y)[source(Master)] : not job(_, doing) & home(HomeX, HomeY) & distance(X, Y, D)
   <- Cost = D + math.sqrt((HomeX - X) ** 2 + (HomeY - Y) ** 2);
      state("bidding for thing ", Id);
      .send(Master, tell, bid(Id, Cost)).
+!call(_, _, _, _).

+rejected(_) : not job(_, doing)
   <- state("waiting for something to fetch").

@take[atomic] // of two awards at one instant it takes one
+!fetch(Id, Color, X, Y)[source(Master)] : not job(_, doing)
   <- -job(Id, _);
      +job(Id, doing);
      !!do(Id, Color, X, Y, Master).
+!fetch(Id, _, _, _) : job(Id, doing).
+!fetch(Id, _, _, _)[source(Master)] // it has got another meanwhile
   <- .send(Master, tell, refused(Id)).

+!do(Id, Color, X, Y, Master)
   <- !collect(Color, X, Y);
      -job(Id, doing);
      +job(Id, done);
      state("waiting for something to fetch");
      .send(Master, tell, fetched(Id)).
-!do(Id, _, _, _, Master)[error_msg(Why)] : job(Id, doing)
   <- state("could not fetch thing ", Id, ": ", Why);
      !put_down;
      -job(Id, doing);
      +job(Id, failed);
      .send(Master, tell, failed(Id)).
-!do(_, _, _, _, _). // nobody wants to know any more

// Where somebody finds it again.
+!put_down : holding
   <- stop;
      release;
      !back_off.
+!put_down
   <- stop.
-!put_down
   <- stop.

+!back_off
   <- drive(-0.2, 0);
      .wait(2500);
      stop.

+!collect(Color, X, Y) : home(HomeX, HomeY) & robot(Me, _)
   <- state("driving to a thing");
      goto_near(X, Y, 0.9);
      release;
      state("looking for the thing");
      !face(Color, X, Y);
      state("driving at the thing");
      !close_in(Color, X, Y);
      stop;
      state("gripping");
      grip;
      state("bringing it home");
      goto_near(HomeX, HomeY, 0.3);
      release;
      !back_off;
      publish(collected, Me, collect_goal(Color, point(X, Y)), point(HomeX, HomeY)).

// Turns until it sees the thing, once around at most.
+!face(Color, X, Y) : sees(Color, X, Y, _, _).
+!face(Color, X, Y)
   <- drive(0, 0.5);
      .wait(sees(Color, X, Y, _, _), 15000).

// Drives at it until it is between the paddles; the last bit, in which its camera does not see it, straight on.
+!close_in(_, _, _) : between.
+!close_in(Color, X, Y) : sees(Color, X, Y, Ahead, Left) & Ahead > 0.35
   <- drive(math.max(0.06, math.min(0.25, 0.5 * (Ahead - 0.3))), math.max(-0.5, math.min(0.5, 1.5 * Left / Ahead)));
      .wait(100);
      !close_in(Color, X, Y).
+!close_in(_, _, _)
   <- drive(0.06, 0);
      .wait(between, 8000).
