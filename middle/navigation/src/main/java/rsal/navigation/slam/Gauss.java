package rsal.navigation.slam;

import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// Two opinions about a pose, each with a covariance in the same frame, joined: the product of two Gaussians.
final class Gauss {
    private Gauss() {}

    static Covariance2d joined(Covariance2d a, Covariance2d b) {
        return inverse(sum(inverse(a), inverse(b)));
    }

    static Pose2d mean(Pose2d a, Covariance2d ofA, Pose2d b, Covariance2d ofB) {
        Covariance2d informationB = inverse(ofB);
        Covariance2d c = inverse(sum(inverse(ofA), informationB));
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

    private static Covariance2d sum(Covariance2d a, Covariance2d b) {
        return new Covariance2d(
                a.xx() + b.xx(),
                a.xy() + b.xy(),
                a.xTheta() + b.xTheta(),
                a.yy() + b.yy(),
                a.yTheta() + b.yTheta(),
                a.thetaTheta() + b.thetaTheta());
    }

    static Covariance2d inverse(Covariance2d c) {
        double a = c.yy() * c.thetaTheta() - c.yTheta() * c.yTheta();
        double b = c.xTheta() * c.yTheta() - c.xy() * c.thetaTheta();
        double d = c.xy() * c.yTheta() - c.yy() * c.xTheta();
        double by = 1 / (c.xx() * a + c.xy() * b + c.xTheta() * d);
        return new Covariance2d(
                a * by,
                b * by,
                d * by,
                (c.xx() * c.thetaTheta() - c.xTheta() * c.xTheta()) * by,
                (c.xy() * c.xTheta() - c.xx() * c.yTheta()) * by,
                (c.xx() * c.yy() - c.xy() * c.xy()) * by);
    }
}
