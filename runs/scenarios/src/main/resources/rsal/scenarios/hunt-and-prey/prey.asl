// Prey: follows the wall on its left until a hunter comes too near, then gives up.

hunter(hunter).      // Role of the robots that catch it, or id of the one.
catchDistance(2.0).  // It is caught when a hunter is nearer than this [m].
period(0.5).         // How often it says where it is [s].

is_hunter(Robot, Role) :- hunter(Robot) | hunter(Role).
distance(X, Y, D) :- pose(MyX, MyY, _) & D = math.sqrt((X - MyX) ** 2 + (Y - MyY) ** 2).

!run.
!report.

+!run
   <- follow_wall;
      state("following the wall").

+!report : pose(X, Y, Th) & robot(Me, Role)
   <- publish(pose, Me, Role, pose(X, Y, Th));
      !pause;
      !!report.
+!report // it does not know yet where it is
   <- !pause;
      !!report.

+!pause : period(Seconds)
   <- .wait(Seconds * 1000).

+heard(pose, _, pose_report(Hunter, Role, pose(X, Y, _)))
   :  not caught & is_hunter(Hunter, Role) & catchDistance(Near) & distance(X, Y, D) & D < Near
      & .in_sight(X, Y)
   <- +caught; // first of all, as another may be near, too
      stop;
      ?robot(Me, _);
      publish(caught, Me, Hunter, D);
      state("caught by ", Hunter);
      show(distance, D).
