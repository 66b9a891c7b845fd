package rsal.jadex;

import rsal.agent.bare.BareSystem;
import rsal.testkit.contract.BareSystemContract;

class BareJadexTest extends BareSystemContract {
    @Override
    protected BareSystem system() {
        return new BareJadex();
    }
}
