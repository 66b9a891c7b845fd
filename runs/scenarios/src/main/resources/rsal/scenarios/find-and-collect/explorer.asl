// Explorer: drives about, looks for things of a color, and says where they are.

color('#2ca02c').  // Of the things that it looks for, as cameras see it.
range(3).          // How far away they may be to count [m].
period(0.5).       // How often it says where it is [s].

in_map(X, Y, MapX, MapY) :- pose(MyX, MyY, Th)
   & MapX = MyX + X * math.cos(Th) - Y * math.sin(Th)
   & MapY = MyY + X * math.sin(Th) + Y * math.cos(Th).
just_told(X, Y) :- told(OtherX, OtherY) & math.sqrt((X - OtherX) ** 2 + (Y - OtherY) ** 2) < 0.6.

!roam.
!report.

+!roam
   <- follow_wall;
      state("following the wall");
      .wait(60000);
      wander;
      state("wandering");
      .wait(20000);
      !!roam.

+!report : period(Seconds)
   <- !say_where;
      .wait(Seconds * 1000);
      !!report.
+!say_where : pose(X, Y, Th) & robot(Me, Role)
   <- publish(pose, Me, Role, pose(X, Y, Th)).
+!say_where.

+blob(Color, X, Y)
   :  color(Color) & range(Range) & math.sqrt(X ** 2 + Y ** 2) < Range & in_map(X, Y, MapX, MapY) & not just_told(MapX, MapY)
   <- +told(MapX, MapY);
      .df_search(fetch, Masters);
      .send(Masters, achieve, found(Color, MapX, MapY));
      .wait(5000);
      -told(MapX, MapY).
