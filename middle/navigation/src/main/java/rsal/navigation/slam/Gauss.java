package rsal.navigation.slam;

import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// Two opinions about a pose, each with a covariance in the same frame, joined: the product of two Gaussians.
final class Gauss {
    private Gauss() {}

    static Covariance2d joined(Covariance2d a, Covariance2d b) {
        return a.inverse().plus(b.inverse()).inverse();
    }

    static Pose2d mean(Pose2d a, Covariance2d ofA, Pose2d b, Covariance2d ofB) {
        Covariance2d informationB = ofB.inverse();
        Covariance2d c = ofA.inverse().plus(informationB).inverse();
        double dx = b.x() - a.x();
        double dy = b.y() - a.y();
        double dt = Angles.difference(a.theta(), b.theta());
        double x = informationB.xx() * dx + informationB.xy() * dy + informationB.xTheta() * dt;
        double y = informationB.xy() * dx + informationB.yy() * dy + informationB.yTheta() * dt;
        double t = informationB.xTheta() * dx + informationB.yTheta() * dy + informationB.thetaTheta() * dt;
        return new Pose2d(
                a.x() + c.xx() * x + c.xy() * y + c.xTheta() * t,
                a.y() + c.xy() * x + c.yy() * y + c.yTheta() * t,
                a.theta() + c.xTheta() * x + c.yTheta() * y + c.thetaTheta() * t);
    }
}
