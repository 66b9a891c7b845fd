// Goes for the newest pose of a prey until that has been caught.

prey(prey).          // Role of the robots to hunt.
catchDistance(1.5).  // It stops when nearer to its prey than this [m].
period(0.5).         // How often it says where it is [s].
interval(2).         // How often it goes for the prey's newest pose [s].

distance(X, Y, D) :- pose(MyX, MyY, _) & D = math.sqrt((X - MyX) ** 2 + (Y - MyY) ** 2).
near(X, Y) :- catchDistance(Near) & distance(X, Y, D) & D < Near & .in_sight(X, Y).

!report.
!hunt.

+!report : pose(X, Y, Th) & robot(Me, Role) & period(Seconds)
   <- publish(pose, Me, Role, pose(X, Y, Th));
      .wait(Seconds * 1000);
      !!report.
+!report : period(Seconds) // it does not know yet where it is
   <- .wait(Seconds * 1000);
      !!report.

+heard(pose, _, pose_report(Prey, Role, pose(X, Y, _))) : prey(Role) & not caught(Prey)
   <- -seen(Prey, _, _);
      +seen(Prey, X, Y).
+heard(caught, _, caught(Prey, Hunter, _))
   <- +caught(Prey);
      -seen(Prey, _, _);
      stop;
      state(Hunter, " has caught ", Prey).

+!hunt : seen(Prey, X, Y) & interval(Seconds)
   <- !approach(Prey, X, Y);
      .wait(Seconds * 1000);
      !!hunt.
+!hunt : interval(Seconds)
   <- .wait(Seconds * 1000);
      !!hunt.

+!approach(Prey, X, Y) : near(X, Y)
   <- stop;
      state("holding ", Prey, " at bay").
+!approach(Prey, X, Y)
   <- state("hunting ", Prey);
      !!go(X, Y).

+!go(X, Y)
   <- goto(X, Y).
-!go(_, _). // a newer goal has taken over, or the next try finds a way
