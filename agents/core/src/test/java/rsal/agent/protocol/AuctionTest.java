package rsal.agent.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.AgentContext;
import rsal.agent.Run;
import rsal.agent.protocol.Auction.Bidder;
import rsal.agent.protocol.Auction.Prices;
import rsal.agent.protocol.Auction.Sale;

class AuctionTest {
    private static final Duration ROUND = Duration.ofSeconds(1);

    private final List<Sale> sales = new ArrayList<>();
    private final Map<String, Sale> told = new TreeMap<>();

    private static Auction<String> auction(AgentContext self, boolean english) {
        return english ? Auction.english(self, "sale", String.class) : Auction.dutch(self, "sale", String.class);
    }

    private void bidder(Run run, boolean english, String name, double worth) {
        run.start(
                name,
                self -> auction(self, english).answer(new Bidder<>() {
                    @Override
                    public boolean pays(String lot, double price) {
                        return price <= worth;
                    }

                    @Override
                    public void ended(String lot, Sale sale) {
                        told.put(name, sale);
                    }
                }));
    }

    private void sell(Run run, boolean english, Prices prices) {
        run.start(
                "zoe",
                self -> auction(self, english).sell(List.of("amy", "bob", "eve"), "a vase", prices, ROUND, sales::add));
    }

    private void bidders(Run run, boolean english) {
        bidder(run, english, "amy", 12);
        bidder(run, english, "bob", 17);
        bidder(run, english, "eve", 15);
    }

    @Test
    void englishAuctionEndsWhereOnlyOneIsLeft() {
        var run = new Run();
        List<String> said = run.transcript();
        bidders(run, true);
        sell(run, true, new Prices(10, 1, 0));
        run.advance(30);
        var sale = new Sale(Optional.of("bob"), 17);
        assertThat(sales).containsExactly(sale);
        assertThat(told).isEqualTo(Map.of("amy", sale, "bob", sale, "eve", sale));
        assertThat(said)
                .startsWith(
                        "zoe -> amy: inform: a vase",
                        "zoe -> bob: inform: a vase",
                        "zoe -> eve: inform: a vase",
                        "zoe -> amy: cfp: 10.0",
                        "zoe -> bob: cfp: 10.0",
                        "zoe -> eve: cfp: 10.0",
                        "amy -> zoe: propose: 10.0",
                        "bob -> zoe: propose: 10.0",
                        "eve -> zoe: propose: 10.0",
                        "zoe -> amy: accept-proposal: 10.0",
                        "zoe -> bob: reject-proposal: 10.0",
                        "zoe -> eve: reject-proposal: 10.0",
                        "zoe -> amy: cfp: 11.0");
    }

    @Test
    void dutchAuctionEndsWithTheFirstWhoWantsIt() {
        var run = new Run();
        bidders(run, false);
        sell(run, false, new Prices(30, -2, 10));
        run.advance(30);
        assertThat(sales).containsExactly(new Sale(Optional.of("bob"), 16));
        assertThat(told).hasSize(3);
    }

    @Test
    void whatNobodyPaysEnoughForIsNotSold() {
        var english = new Run();
        bidders(english, true);
        sell(english, true, new Prices(10, 1, 20));
        english.advance(30);
        var dutch = new Run();
        bidders(dutch, false);
        sell(dutch, false, new Prices(30, -2, 20));
        dutch.advance(30);
        assertThat(sales).containsExactly(new Sale(Optional.empty(), 17), new Sale(Optional.empty(), 20));
    }

    @Test
    void pricesGoTheRightWay() {
        new Run().start("zoe", self -> {
            assertThatThrownBy(() -> sell(new Run(), true, new Prices(1, Double.NaN, 0)))
                    .isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() ->
                            auction(self, true).sell(List.of(), "a vase", new Prices(1, -1, 0), ROUND, sales::add))
                    .hasMessageContaining("rise");
            assertThatThrownBy(() ->
                            auction(self, false).sell(List.of(), "a vase", new Prices(1, 1, 0), ROUND, sales::add))
                    .hasMessageContaining("fall");
        });
    }

    @Test
    void leaderThatDiesDoesNotWin() {
        var run = new Run();
        bidders(run, true);
        sell(run, true, new Prices(10, 1, 0));
        run.advance(8.5); // bob has 17 since 7 s
        run.stop("bob");
        run.advance(30);
        assertThat(sales).hasSize(1);
        assertThat(sales.getFirst().winner()).isNotEqualTo(Optional.of("bob"));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void inBadWeatherThereIsOneWinnerAtMostAndAllHearTheSame(boolean english) {
        int sold = 0;
        for (int seed = 0; seed < 100; seed++) {
            var storm = new Run();
            storm.deliverBy(new Weather(new SplittableRandom(seed), 0.2, 0.2, Duration.ofMillis(300)));
            sales.clear();
            told.clear();
            bidders(storm, english);
            sell(storm, english, english ? new Prices(10, 1, 0) : new Prices(30, -2, 10));
            storm.advance(60);
            assertThat(sales).as("seed %d", seed).hasSize(1);
            assertThat(told.values()).as("seed %d", seed).allMatch(sales.getFirst()::equals);
            sold += sales.getFirst().winner().isPresent() ? 1 : 0;
        }
        assertThat(sold).isGreaterThan(95);
    }
}
