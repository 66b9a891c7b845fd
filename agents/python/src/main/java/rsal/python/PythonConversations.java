package rsal.python;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.protocol.Auction;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.Conversation;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Propose;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.RetryPolicy;
import rsal.agent.protocol.Subscribe;
import rsal.device.Subscription;
import rsal.python.PythonRequests.Heard;

/// The conversations of an agent in Python: requests, contract nets, auctions, proposals and subscriptions, about maps.
/// On the
/// agent's lane.
@SuppressWarnings("rawtypes") // the contents of a conversation are told by a class, which has no parameters
final class PythonConversations {
    private final AgentContext self;
    private final Heard heard;
    private final Map<String, Request<Map, Map>> requests = new HashMap<>(); // by service
    private final Map<String, ContractNet<Map, Map, Map>> nets = new HashMap<>(); // by service
    private final Map<Integer, BiConsumer<String, Object>> dialogues = new HashMap<>(); // what Python can say in each
    private final Map<String, Auction<Map>> english = new HashMap<>(); // by service
    private final Map<String, Auction<Map>> dutch = new HashMap<>(); // by service
    private final Map<String, Propose<Map>> proposals = new HashMap<>(); // by service
    private final Map<String, Subscribe<Map, Map>> news = new HashMap<>(); // by service
    private final Map<Integer, Subscribe.Subscriber<Map, Map>> subscribers = new HashMap<>(); // that want news
    private final Map<Integer, Subscription> held;
    private int begun;

    /// @param held what Python may cancel, by number
    PythonConversations(AgentContext self, Heard heard, Map<Integer, Subscription> held) {
        this.self = self;
        this.heard = heard;
        this.held = held;
    }

    void perform(PythonRequests.Request asked) {
        switch (asked.verb()) {
            case "ask" -> ask(asked);
            case "answer" -> answer(asked.number(0), asked.text(1));
            case "tender" -> tender(asked);
            case "bid" -> bid(asked.number(0), asked.text(1));
            case "suggest" -> suggest(asked);
            case "judge" -> judge(asked.number(0), asked.text(1));
            case "follow" -> follow(asked);
            case "admit" -> admit(asked.number(0), asked.text(1));
            case "sell" -> sell(asked);
            case "buy" -> buy(asked.number(0), auction(asked.text(1), Boolean.TRUE.equals(asked.argument(2))));
            case "tell", "endTelling" -> tell(asked);
            case "agree", "inform", "refuse", "fail", "propose" -> say(asked);
            default -> throw new IllegalArgumentException("RSAL has no '%s'.".formatted(asked.verb()));
        }
    }

    private Request<Map, Map> request(String service) {
        return requests.computeIfAbsent(service, name -> new Request<>(self, name, Map.class, Map.class));
    }

    private ContractNet<Map, Map, Map> net(String service) {
        return nets.computeIfAbsent(service, name -> new ContractNet<>(self, name, Map.class, Map.class, Map.class));
    }

    private Auction<Map> auction(String service, boolean isDutch) {
        return isDutch
                ? dutch.computeIfAbsent(service, name -> Auction.dutch(self, name, Map.class))
                : english.computeIfAbsent(service, name -> Auction.english(self, name, Map.class));
    }

    private void sell(PythonRequests.Request asked) {
        int number = asked.number(0);
        var prices = new Auction.Prices(
                FromWords.number(asked.argument(4)),
                FromWords.number(asked.argument(5)),
                FromWords.number(asked.argument(6)));
        auction(asked.text(1), prices.step() < 0)
                .sell(
                        names(asked.list(3)),
                        FromWords.map(orEmpty(asked.argument(2))),
                        prices,
                        asked.seconds(7),
                        sale -> heard.hear(number, false, words(sale)));
    }

    private static Map<String, Object> words(Auction.Sale sale) {
        return Map.of("winner", sale.winner().orElse(""), "price", sale.price(), "why", "");
    }

    private void buy(int number, Auction<Map> auction) {
        auction.answer(new Auction.Bidder<>() {
            @Override
            public boolean pays(Map lot, double price) {
                return false; // Python says so a little later
            }

            @Override
            public void asked(Map lot, double price, Runnable pays) {
                int dialogue = dialogue((verb, _) -> {
                    if (verb.equals("propose")) {
                        pays.run();
                    }
                });
                heard.hear(number, false, Map.of("content", lot, "price", price, "dialogue", dialogue));
            }

            @Override
            public void ended(Map lot, Auction.Sale sale) {
                var ending = new LinkedHashMap<String, Object>(words(sale));
                ending.put("content", lot);
                heard.hear(number, false, ending);
            }

            @Override
            public void lost(Map lot, String why) {
                heard.hear(number, false, Map.of("winner", "", "price", Double.NaN, "why", why, "content", lot));
            }
        });
    }

    private static List<String> names(List<?> words) {
        return words.stream().map(String::valueOf).toList();
    }

    private void ask(PythonRequests.Request asked) {
        int number = asked.number(0);
        request(asked.text(2))
                .ask(
                        asked.text(1),
                        FromWords.map(orEmpty(asked.argument(3))),
                        patience(asked.seconds(4)),
                        ending -> heard.hear(number, false, words(ending)));
    }

    private static Object orEmpty(@Nullable Object words) {
        return words == null ? Map.of() : words;
    }

    private static Map<String, Object> words(ConversationResult<Map> ending) {
        return words(ending, result -> result);
    }

    /// @param written what is informed, in words
    static <T> Map<String, Object> words(ConversationResult<T> ending, Function<? super T, ?> written) {
        var words = new LinkedHashMap<String, Object>(Map.of("content", Map.of(), "why", ""));
        switch (ending) {
            case ConversationResult.Informed<T>(T result) -> {
                words.put("how", "informed");
                words.put("content", written.apply(result));
            }
            case ConversationResult.Refused<T>(String why) -> ended(words, "refused", why);
            case ConversationResult.Failed<T>(String why) -> ended(words, "failed", why);
            case ConversationResult.NotUnderstood<T>(String why) -> ended(words, "not understood", why);
            case ConversationResult.Silent<T>(String why) -> ended(words, "silent", why);
            case ConversationResult.Cancelled<T>() -> ended(words, "cancelled", "");
        }
        return words;
    }

    private static void ended(Map<String, Object> words, String how, String why) {
        words.put("how", how);
        words.put("why", why);
    }

    private Propose<Map> proposals(String service) {
        return proposals.computeIfAbsent(service, name -> new Propose<>(self, name, Map.class));
    }

    private Subscribe<Map, Map> news(String service) {
        return news.computeIfAbsent(service, name -> new Subscribe<>(self, name, Map.class, Map.class));
    }

    private static RetryPolicy patience(Duration silence) {
        Duration usual = RetryPolicy.DEFAULT.repeat();
        return new RetryPolicy(silence.compareTo(usual) < 0 ? silence : usual, silence);
    }

    private void suggest(PythonRequests.Request asked) {
        int number = asked.number(0);
        proposals(asked.text(2))
                .propose(
                        asked.text(1),
                        FromWords.map(orEmpty(asked.argument(3))),
                        patience(asked.seconds(4)),
                        ending -> heard.hear(number, false, words(ending, _ -> Map.of())));
    }

    private void judge(int number, String service) {
        proposals(service).decide(proposal -> {
            int dialogue = dialogue((verb, content) -> proposal.decide(
                    verb.equals("inform") ? Propose.Verdict.accept() : Propose.Verdict.reject(content.toString())));
            heard.hear(
                    number, false, Map.of("sender", proposal.from(), "content", proposal.what(), "dialogue", dialogue));
        });
    }

    private void follow(PythonRequests.Request asked) {
        int number = asked.number(0);
        Conversation talk = news(asked.text(2))
                .subscribe(
                        asked.text(1),
                        FromWords.map(orEmpty(asked.argument(3))),
                        patience(asked.seconds(4)),
                        content -> heard.hear(number, false, Map.of("how", "", "content", content, "why", "")),
                        ending -> heard.hear(number, false, words(ending)));
        held.put(number, talk::cancel);
    }

    private void admit(int number, String service) {
        news(service).answer(subscriber -> {
            begun++;
            int dialogue = begun;
            subscribers.put(dialogue, subscriber);
            subscriber.whenUnwanted(() -> {
                subscribers.remove(dialogue);
                heard.hear(number, false, Map.of("over", dialogue));
            });
            heard.hear(
                    number,
                    false,
                    Map.of("sender", subscriber.from(), "content", subscriber.what(), "dialogue", dialogue));
        });
    }

    private void tell(PythonRequests.Request asked) {
        Subscribe.Subscriber<Map, Map> subscriber = subscribers.get(asked.number(0));
        if (subscriber == null) {
            return; // it has gone
        }
        if (asked.verb().equals("tell")) {
            subscriber.inform(FromWords.map(orEmpty(asked.argument(1))));
            return;
        }
        subscribers.remove(asked.number(0));
        if (Boolean.TRUE.equals(asked.argument(2))) {
            subscriber.refuse(asked.text(1));
        } else {
            subscriber.fail(asked.text(1));
        }
    }

    private void say(PythonRequests.Request asked) {
        int dialogue = asked.number(0);
        BiConsumer<String, Object> partner = dialogues.get(dialogue);
        if (partner != null) { // else it is not wanted any more
            if (!asked.verb().equals("agree")) {
                dialogues.remove(dialogue);
            }
            partner.accept(asked.verb(), asked.words().size() > 3 ? orEmpty(asked.argument(1)) : "");
        }
    }

    private int dialogue(BiConsumer<String, Object> partner) {
        begun++;
        dialogues.put(begun, partner);
        return begun;
    }

    private void answer(int number, String service) {
        request(service).answer(question -> {
            int dialogue = dialogue((verb, content) -> {
                switch (verb) {
                    case "agree" -> question.agree();
                    case "inform" -> question.inform(FromWords.map(content));
                    case "refuse" -> question.refuse(content.toString());
                    default -> question.fail(content.toString());
                }
            });
            question.whenUnwanted(() -> dialogues.remove(dialogue));
            heard.hear(
                    number, false, Map.of("sender", question.from(), "content", question.what(), "dialogue", dialogue));
        });
    }

    private void bid(int number, String service) {
        net(service).answer(new ContractNet.Contractor<>() {
            @Override
            public void called(ContractNet.Call<Map, Map> call) {
                int dialogue = dialogue((verb, content) -> {
                    if (verb.equals("propose")) {
                        call.propose(FromWords.map(content));
                    } else {
                        call.refuse(content.toString());
                    }
                });
                heard.hear(
                        number,
                        false,
                        Map.of(
                                "sender",
                                call.from(),
                                "content",
                                call.task(),
                                "replyBy",
                                call.replyBy(),
                                "dialogue",
                                dialogue));
            }

            @Override
            public void accepted(ContractNet.Contract<Map, Map> contract) {
                int dialogue = dialogue((verb, content) -> {
                    switch (verb) {
                        case "agree" -> {} // the accepted bid has said so
                        case "inform" -> contract.inform(FromWords.map(content));
                        default -> contract.fail(content.toString());
                    }
                });
                contract.whenUnwanted(() -> dialogues.remove(dialogue));
                heard.hear(
                        number,
                        false,
                        Map.of("sender", contract.from(), "content", contract.task(), "dialogue", dialogue));
            }
        });
    }

    /// By what a bid is chosen; NaN for none.
    private static double rank(ContractNet.Proposal<Map> proposal, String criterion) {
        return proposal.bid().get(criterion) instanceof Number number ? number.doubleValue() : Double.NaN;
    }

    /// Bids with a number to choose by, the best first. Of equal ones the first by name is. Others count as none.
    private List<ContractNet.Proposal<Map>> ranked(
            List<ContractNet.Proposal<Map>> bids, String criterion, boolean least) {
        var usable = new ArrayList<ContractNet.Proposal<Map>>();
        for (ContractNet.Proposal<Map> bid : bids) {
            if (Double.isNaN(rank(bid, criterion))) {
                self.print("The bid of '%s' has no number '%s', and is left out: %s"
                        .formatted(bid.from(), criterion, bid.bid()));
            } else {
                usable.add(bid);
            }
        }
        usable.sort(Comparator.comparingDouble(bid -> least ? rank(bid, criterion) : -rank(bid, criterion)));
        return usable;
    }

    private void tender(PythonRequests.Request asked) {
        int number = asked.number(0);
        String criterion = asked.text(5);
        boolean least = Boolean.TRUE.equals(asked.argument(6));
        int most = asked.number(7);
        List<String> to = names(asked.list(3));
        net(asked.text(1))
                .call(to, FromWords.map(orEmpty(asked.argument(2))), asked.seconds(4), new ContractNet.Manager<>() {
                    @Override
                    public ContractNet.Verdict<Map> decide(ContractNet.Round<Map> round) {
                        List<Map<String, Object>> chosen = ranked(round.proposals(), criterion, least).stream()
                                .limit(most)
                                .map(each -> Map.<String, Object>of("sender", each.from(), "bid", each.bid()))
                                .toList();
                        heard.hear(
                                number,
                                false,
                                Map.of("proposals", round.proposals().size(), "chosen", chosen));
                        return new ContractNet.Verdict.Award<>(chosen.stream()
                                .map(each -> String.valueOf(each.get("sender")))
                                .collect(Collectors.toCollection(LinkedHashSet::new)));
                    }

                    @Override
                    public void ended(ContractNet.Proposal<Map> accepted, ConversationResult<Map> how) {
                        var words = new LinkedHashMap<String, Object>(words(how));
                        words.put("sender", accepted.from());
                        heard.hear(number, false, words);
                    }
                });
    }
}
